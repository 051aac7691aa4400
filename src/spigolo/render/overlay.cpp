// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/overlay.cpp
#include "spigolo/render/overlay.h"

#include <algorithm>
#include <array>
#include <cstdio>

namespace spigolo {
namespace {

constexpr double margin = 1.8;  // all lengths here in letter sizes
constexpr double title_size = 1.35;
constexpr double row_height = 2.2;

std::string text_of(const LegendEntry& entry) {
  std::string text = entry.label;
  if (entry.count) text.append(1, ' ').append(grouped(*entry.count));
  return text;
}

// Calls place(entry, spot of its dot) for each legend entry, row by row; returns the last base
// line.
template <class Place>
double lay_out(const Image& image, std::span<const LegendEntry> legend, double y,
               const Place& place) {
  const double size = letter_size(image.width, image.height);
  const TextStyle style{size};
  double x = margin * size;
  for (const LegendEntry& entry : legend) {
    const double width = 1.6 * size + text_width(text_of(entry), style);
    if (x > margin * size && x + width > image.width - margin * size)
      x = margin * size, y += row_height * size;
    place(entry, Spot{x, y});
    x += width + 2.2 * size;
  }
  return y;
}

template <class Place>
double lay_out_heading(const Image& image, const std::string& title,
                       std::span<const LegendEntry> legend, const Place& place) {
  const double size = letter_size(image.width, image.height);
  double y = margin * size;
  if (!title.empty()) y += title_size * size;
  if (!legend.empty()) {
    y += (title.empty() ? 1.0 : row_height) * size;
    y = lay_out(image, legend, y, place);
  }
  return y + size;
}

}  // namespace

double letter_size(int width, int height) {
  return std::max(7.0, 0.0145 * std::min(1.0 * height, 0.75 * width));
}

std::string grouped(std::size_t count) {
  std::string text = std::to_string(count);
  for (std::size_t i = text.size(); i > 3; i -= 3) text.insert(i - 3, 1, ' ');
  return text;
}

std::string short_number(double value) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.4g", value == 0 ? 0.0 : value);
  return text.data();
}

double round_below(double x) {
  const double power = std::pow(10, std::floor(std::log10(x)));
  for (const double step : {5.0, 2.0})
    if (step * power <= x) return step * power;
  return power;
}

double heading_height(const Image& image, const std::string& title,
                      std::span<const LegendEntry> legend) {
  return lay_out_heading(image, title, legend, [](const LegendEntry&, Spot) {});
}

double draw_heading(Image& image, const std::string& title, std::span<const LegendEntry> legend) {
  const double size = letter_size(image.width, image.height);
  if (!title.empty())
    draw_text(image, {margin * size, (margin + title_size) * size}, title,
              {title_size * size, ink, 1.3});
  return lay_out_heading(image, title, legend, [&](const LegendEntry& entry, Spot at) {
    draw_dot(image, {at.x + 0.5 * size, at.y - 0.5 * size}, 0.52 * size, entry.color);
    draw_text(image, {at.x + 1.6 * size, at.y}, text_of(entry), {size, ink});
  });
}

double color_bar_width(const Image& image) { return 8.5 * letter_size(image.width, image.height); }

void draw_color_bar(Image& image, const ColorBar& bar) {
  const double size = letter_size(image.width, image.height);
  const double x = image.width - 7.2 * size, width = 1.4 * size;
  const double y0 = 0.25 * image.height, y1 = 0.75 * image.height;
  fill_box(image, {x - 1, y0 - 1}, {x + width + 1, y1 + 1}, pale_ink);
  for (double y = y0; y < y1; ++y)
    fill_box(image, {x, y}, {x + width, std::min(y + 1, y1)},
             map_color(bar.map, (y1 - y - 0.5) / (y1 - y0)));
  for (int tick = 0; tick <= 4; ++tick) {
    const double y = y1 + (y0 - y1) * tick / 4;
    draw_line(image, {x + width + 1, y}, {x + width + 0.45 * size, y}, 0.11 * size, ink);
    draw_text(image, {x + width + 0.8 * size, y + 0.4 * size},
              short_number(bar.low + (bar.high - bar.low) * tick / 4), {0.85 * size, ink});
  }
  const TextStyle style{0.95 * size, ink};
  const double left = std::min(x, image.width - size - text_width(bar.label, style));
  draw_text(image, {left, y0 - 1.4 * size}, bar.label, style);
}

void draw_scale_bar(Image& image, double unit) {
  const double size = letter_size(image.width, image.height);
  const double length = round_below(0.2 * image.width * unit), pixels = length / unit;
  if (!std::isfinite(pixels)) return;
  const double x1 = image.width - margin * size, x0 = x1 - pixels;
  const double y = image.height - margin * size, weight = 0.14 * size;
  draw_line(image, {x0, y}, {x1, y}, weight, ink);
  for (const double x : {x0, x1}) draw_line(image, {x, y - 0.5 * size}, {x, y}, weight, ink);
  const TextStyle style{size, ink};
  const std::string text = short_number(length);
  draw_text(image, {0.5 * (x0 + x1 - text_width(text, style)), y - 0.7 * size}, text, style);
}

void draw_axes(Image& image, const Camera& camera) {
  const double size = letter_size(image.width, image.height), length = 3.2 * size;
  const Spot at{(margin + 3.2) * size, image.height - (margin + 3.2) * size};
  const std::array<Vec3, 3> axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  std::array<std::size_t, 3> order = {0, 1, 2};  // the farthest end first
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return dot(axes[a], camera.forward) > dot(axes[b], camera.forward);
  });
  for (const std::size_t k : order) {
    const double dx = dot(axes[k], camera.right), dy = -dot(axes[k], camera.up);
    draw_line(image, at, {at.x + length * dx, at.y + length * dy}, 0.2 * size, axis_colors[k]);
    if (std::hypot(dx, dy) < 0.15) continue;  // seen end on: no room for a letter
    const double reach = length + 0.9 * size;
    draw_text(image, {at.x + reach * dx - 0.28 * size, at.y + reach * dy + 0.35 * size},
              std::string_view("xyz").substr(k, 1), {0.9 * size, axis_colors[k]});
  }
}

}  // namespace spigolo
