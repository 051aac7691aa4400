// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/panels.cpp - several scenes in one picture
#include "spigolo/core/error.h"
#include "spigolo/render/auto_view.h"
#include "spigolo/render/overlay.h"
#include "spigolo/render/render.h"

namespace spigolo {
namespace {

constexpr double panel_shape = 1.2;  // width to height that suits most scenes

// The number of columns whose panels come nearest to the wanted shape.
int best_columns(int panels, int width, int height) {
  int best = 1;
  double best_misfit = infinity;
  for (int columns = 1; columns <= panels; ++columns) {
    const int rows = (panels + columns - 1) / columns;
    const double shape = (1.0 * width / columns) / (1.0 * height / rows);
    const double empty = columns * rows - panels;
    const double misfit = std::abs(std::log(shape / panel_shape)) + 0.3 * empty;
    if (misfit < best_misfit) best_misfit = misfit, best = columns;
  }
  return best;
}

void paste(Image& image, const Image& part, int x0, int y0) {
  for (int y = 0; y < part.height; ++y)
    for (int x = 0; x < part.width; ++x)
      if (image.contains(x0 + x, y0 + y)) image.at(x0 + x, y0 + y) = part.at(x, y);
}

}  // namespace

Image render_panels(std::span<const Panel> panels, const RenderOptions& options, const Job& job) {
  if (panels.empty()) throw UsageError("a picture needs at least one panel");
  Image image(options.width, options.height, options.top);
  const double size = letter_size(options.width, options.height);
  const int top = options.title.empty() ? 0 : static_cast<int>(4.5 * size);
  const int count = static_cast<int>(panels.size());
  const int columns = best_columns(count, options.width, options.height - top);
  const int rows = (count + columns - 1) / columns;
  RenderOptions part = options;
  part.width = options.width / columns, part.height = (options.height - top) / rows;
  for (const Panel& panel : panels) validate(panel.scene);
  if (!part.view.direction) part.view.direction = best_direction(panels[0].scene, part.view);
  for (int i = 0; i < count; ++i) {
    const Panel& panel = panels[static_cast<std::size_t>(i)];
    part.title = panel.title;
    const int x = options.width * (i % columns) / columns, y = top + part.height * (i / columns);
    paste(image, render(panel.scene, part, job), x, y);
    if (i % columns > 0)
      fill_box(image, {x - 0.5, y + 0.0}, {x + 0.5, 1.0 * y + part.height}, {205, 210, 218});
  }
  if (top > 0) draw_text(image, {1.8 * size, 3.2 * size}, options.title, {1.35 * size, ink, 1.3});
  return image;
}

}  // namespace spigolo
