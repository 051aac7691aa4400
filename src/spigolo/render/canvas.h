// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/canvas.h - flat drawing over a finished picture: text, lines, boxes
#pragma once

#include <string_view>

#include "spigolo/core/geometry.h"
#include "spigolo/render/image.h"

namespace spigolo {

/// A place on the picture in pixels from its top left corner.
struct Spot {
  double x = 0, y = 0;
};

/// Smooth-edged line with round ends.
void draw_line(Image& image, Spot a, Spot b, double width, Color color);
/// Smooth-edged filled circle.
void draw_dot(Image& image, Spot center, double radius, Color color);
void fill_box(Image& image, Spot corner, Spot opposite, Color color);

/// How a text looks. size: height of a capital letter [pixel].
struct TextStyle {
  double size = 12;
  Color color = ink;
  double weight = 1;  // of the strokes, 1.5 is bold
};

/// Width in pixels of a line of text. Other characters than ASCII 32 to 126 are drawn as '?'.
double text_width(std::string_view text, const TextStyle& style);
/// at: left end of the base line.
void draw_text(Image& image, Spot at, std::string_view text, const TextStyle& style);

}  // namespace spigolo
