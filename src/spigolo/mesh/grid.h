// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/grid.h - points on an integer grid, where signs of determinants are exact and cheap
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "spigolo/core/geometry.h"

namespace spigolo {

/// Whole numbers, stored as doubles; at most 2^22 away from 0.
using GridPoint = Vec3;

inline constexpr double grid_reach = 1 << 22;

/// Maps a cloud into the middle quarter of the grid, so that a tetrahedron around it fits.
struct Grid {
  Vec3 origin;       // mapped to 0
  double scale = 1;  // grid units per unit of the points

  /// Rounded, and shifted at random by up to `jitter` grid units: no four points in one plane and
  /// no five on one sphere but by rare accident. seed: other numbers, other shifts.
  GridPoint place(const Vec3& p, double jitter, std::uint64_t seed) const;
};

/// Throws nothing; a single place gets scale 1.
Grid make_grid(const Box& bounds);

/// Sign of det(b - a, c - a, d - a): 1 for a positive tetrahedron, 0 for a flat one.
int grid_orient(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d);

/// Positive if e lies inside of the sphere through the corners of the positive tetrahedron a b c d.
int grid_in_sphere(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d,
                   const GridPoint& e);

}  // namespace spigolo
