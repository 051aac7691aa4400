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
};

/// What the options say, with every 0 replaced.
Setbacks choose_setbacks(const BlendOptions& options, const CloudSide& cloud);

/// Height and width of every strand. A ball of the radius that touches both sides touches them at
/// R cot(angle / 2) from X; at least 2.5 spacings, at most what the face offers before its start
/// and half of the gap to another border (thesis §5.4.2.6 asks for more room in close curves).
/// Lengths are smoothed along X over six radii to both sides. others: points of the other
/// intersections. Throws NoResultError if the face is too short for the least collar, or for the
/// one asked for.
void set_lengths(const Isolines& isolines, const Setbacks& setbacks, double spacing,
                 std::span<const Vec3> others, BorderLoop& loop);

}  // namespace spigolo
