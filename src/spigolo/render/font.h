// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/font.h - a stroke font of our own, ASCII 32 to 126
#pragma once

#include <vector>

#include "spigolo/core/geometry.h"

namespace spigolo {

inline constexpr double font_cap_height = 9;  // [font unit]

/// Lines of one character in font units: x right, y up from the base line, capitals 9 high.
struct Glyph {
  double advance = 0;                      // to the next character
  std::vector<std::vector<Vec3>> strokes;  // z is 0; a single point is a dot
};

/// Of '?' for characters outside the font.
const Glyph& glyph(char c);

}  // namespace spigolo
