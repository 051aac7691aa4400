// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/heat_map.cpp
#include "heat_map.h"

#include <cmath>

#include "picture.h"
#include "report.h"
#include "spigolo/render/canvas.h"

namespace spigolo::bench {
namespace {

constexpr double cell_width = 44, cell_height = 26, left = 70, top = 64, gap = 30, bottom = 20;

double panel_width(const HeatMap& map) {
  return left + cell_width * static_cast<double>(map.columns.size()) + gap;
}

void centered(Image& image, Spot middle, const std::string& text, const TextStyle& style) {
  draw_text(image, {middle.x - text_width(text, style) / 2, middle.y + style.size / 2}, text,
            style);
}

void draw_panel(Image& image, double x0, const HeatMap& map) {
  draw_text(image, {x0 + left, 20}, map.title, {12, ink, 1});
  draw_text(image, {x0 + left, 38}, map.across, {9, pale_ink, 1});
  draw_text(image, {x0 + 6, top - 8}, map.down, {9, pale_ink, 1});
  for (std::size_t c = 0; c < map.columns.size(); ++c)
    centered(image, {x0 + left + cell_width * (static_cast<double>(c) + 0.5), top - 12},
             map.columns[c], {9, ink, 1});
  for (std::size_t r = 0; r < map.rows.size(); ++r) {
    const double y = top + cell_height * static_cast<double>(r);
    centered(image, {x0 + left - 24, y + cell_height / 2}, map.rows[r], {9, ink, 1});
    for (std::size_t c = 0; c < map.columns.size(); ++c) {
      const double x = x0 + left + cell_width * static_cast<double>(c), v = map.value[r][c];
      fill_box(image, {x, y}, {x + cell_width - 1, y + cell_height - 1},
               map_color(ColorMap::sequential, v));
      const Color text = v > 0.6 ? ink : Color{255, 255, 255};
      centered(image, {x + cell_width / 2, y + cell_height / 2}, number(v, 2), {9, text, 1});
    }
  }
}

}  // namespace

void write_heat_maps(const std::filesystem::path& png, const std::vector<HeatMap>& panels) {
  double width = 0, height = 0;
  for (const HeatMap& map : panels) {
    width += panel_width(map);
    height = std::max(height, top + cell_height * static_cast<double>(map.rows.size()) + bottom);
  }
  Image image(static_cast<int>(width), static_cast<int>(height));
  double x = 0;
  for (const HeatMap& map : panels) {
    draw_panel(image, x, map);
    x += panel_width(map);
  }
  save_picture(png, image, kept_colors);
}

}  // namespace spigolo::bench
