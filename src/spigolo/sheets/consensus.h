// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/consensus.h - the plane through a point that its neighbors agree with best
#pragma once

#include <span>

#include "spigolo/core/geometry.h"

namespace spigolo {

/// Unit normal of the plane through points[0] and two of its neighbors that the points agree with
/// best: each counts the more the closer it lies, none beyond the tolerance (in the unit of the
/// points). Of many neighbors only about twenty, evenly taken, make planes. The zero vector if all
/// triangles are needles. At most 128 points.
Vec3 consensus_plane(std::span<const Vec3> points, double tolerance);

}  // namespace spigolo
