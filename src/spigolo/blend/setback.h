// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/setback.h - how far from the intersection the collar begins and ends
#pragma once

#include "spigolo/blend/cloud_side.h"
#include "spigolo/blend/options.h"
#include "spigolo/blend/strand.h"

namespace spigolo {

/// Directions across X and the angle between them, from the normals and loop.side. Where face and
/// cloud nearly touch, the direction along X is that of the curve itself.
void set_directions(BorderLoop& loop);

/// Lengths in the units of the points, the same for all borders of one blend.
struct Setbacks {
  double radius = 0;             // of the rolling ball; 0: height and width are given
  double height = 0, width = 0;  // constant ones
  bool chosen = false;           // the radius is no wish of the user: it may become smaller
};

/// What the options say, with every 0 replaced.
Setbacks choose_setbacks(const BlendOptions& options, const CloudSide& cloud);

/// What sets the size of the collar at every strand: the radius of the ball, or height and width. A
/// ball of radius R touches both sides at R cot(angle / 2) from X, so that acute angles get more
/// room by themselves (thesis §5.4.2.6 asks for it in close curves); where that is less than 2.5
/// spacings the ball is larger, and where the face before its start or half of the gap to another
/// border is less, it is smaller. Radii are smoothed along X. others: points of the other
/// intersections. Throws NoResultError if the face is too short for the least collar, or for the
/// height asked for.
void set_lengths(const Isolines& isolines, const Setbacks& setbacks, double spacing,
                 std::span<const Vec3> others, BorderLoop& loop);

}  // namespace spigolo
