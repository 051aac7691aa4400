// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/line_chart.cpp
#include "line_chart.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "picture.h"
#include "report.h"
#include "spigolo/render/canvas.h"

namespace spigolo::bench {
namespace {

constexpr double width = 250, height = 190, left = 46, top = 44, right = 14, bottom = 40;
constexpr int ticks = 5;
constexpr std::array<Color, 4> colors = {
    {{31, 119, 180}, {214, 69, 65}, {44, 140, 70}, {130, 90, 160}}};
constexpr Color grid = {225, 225, 225};

// "1.5", "30 k", "1 M".
std::string short_text(double x) {
  if (x >= 1e6) return number(x / 1e6) + " M";
  if (x >= 1e3) return number(x / 1e3) + " k";
  return number(x, x == std::floor(x) ? 0 : 1);
}

class Panel {
 public:
  Panel(Image& image, double x0, const LineChart& chart) : image_(image), x0_(x0), chart_(chart) {}

  void draw() const {
    draw_text(image_, {x0_ + left, 16}, chart_.title, {11, ink, 1});
    draw_text(image_, {x0_ + left, 34}, chart_.up, {8, pale_ink, 1});
    draw_text(image_, {x0_ + left, top + height + 34}, chart_.across, {8, pale_ink, 1});
    draw_grid();
    for (std::size_t c = 0; c < chart_.curves.size(); ++c) draw_curve(c);
  }

 private:
  static double scaled(double value, bool decades) { return decades ? std::log10(value) : value; }
  // Share of the way from a to b.
  static double share(double value, double a, double b, bool decades) {
    return (scaled(value, decades) - scaled(a, decades)) /
           (scaled(b, decades) - scaled(a, decades));
  }

  Spot place(double x, double value) const {
    const double shown = std::clamp(value, chart_.low, chart_.high);
    const double up = share(shown, chart_.low, chart_.high, chart_.decades);
    const double across = share(x, chart_.x.front(), chart_.x.back(), chart_.x_decades);
    return {x0_ + left + across * width, top + (1 - up) * height};
  }

  void draw_grid() const {
    for (const double x : chart_.x) {
      draw_line(image_, place(x, chart_.low), place(x, chart_.high), 1, grid);
      const std::string text = short_text(x);
      const Spot at = place(x, chart_.low);
      draw_text(image_, {at.x - text_width(text, {8, ink, 1}) / 2, at.y + 16}, text, {8, ink, 1});
    }
    for (const double value : marks()) {
      const Spot at = place(chart_.x.front(), value);
      draw_line(image_, at, place(chart_.x.back(), value), 1, grid);
      const std::string text = number(value, value < 1 ? 1 : 0);
      draw_text(image_, {at.x - 8 - text_width(text, {8, ink, 1}), at.y + 4}, text, {8, ink, 1});
    }
  }

  std::vector<double> marks() const {
    std::vector<double> values;
    if (chart_.decades)
      for (double v = chart_.low; v < 1.01 * chart_.high; v *= 10) values.push_back(v);
    else
      for (int t = 0; t <= ticks; ++t)
        values.push_back(chart_.low + (chart_.high - chart_.low) * t / ticks);
    return values;
  }

  void draw_curve(std::size_t c) const {
    const auto& [name, values] = chart_.curves[c];
    const Color color = colors[c % colors.size()];
    for (std::size_t i = 0; i < values.size(); ++i) {
      const Spot at = place(chart_.x[i], values[i]);
      if (i > 0) draw_line(image_, place(chart_.x[i - 1], values[i - 1]), at, 1.6, color);
      draw_dot(image_, at, 2.6, color);
    }
    const double y = top + (chart_.legend_below ? height - 42 : 12) + 15 * static_cast<double>(c);
    const double x = x0_ + left + (chart_.legend_below ? 24 : width - 110);
    draw_dot(image_, {x - 9, y - 4}, 3, color);
    draw_text(image_, {x, y}, name, {8, ink, 1});
  }

  Image& image_;
  double x0_;
  const LineChart& chart_;
};

}  // namespace

void write_line_charts(const std::filesystem::path& png, const std::vector<LineChart>& panels) {
  constexpr double step = left + width + right;
  Image image(static_cast<int>(step * static_cast<double>(panels.size())),
              static_cast<int>(top + height + bottom));
  for (std::size_t p = 0; p < panels.size(); ++p)
    Panel(image, step * static_cast<double>(p), panels[p]).draw();
  save_picture(png, image, kept_colors);
}

}  // namespace spigolo::bench
