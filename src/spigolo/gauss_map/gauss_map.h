// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/gauss_map/gauss_map.h - the discrete Gauss map of a neighborhood (thesis §3.4.3)
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "spigolo/core/geometry.h"

namespace spigolo {

/// Unit normals of the triangles (p, p_i, p_j), i < j: one of each pair x_ij, x_ji, since only the
/// lines they span are ever compared. Structs of floats for the vector units; the arrays are longer
/// than size, what lies beyond is not part of the map.
struct GaussMap {
  std::size_t size = 0;
  std::vector<float> x, y, z;

  Vec3 normal(std::size_t t) const { return {x[t], y[t], z[t]}; }
};

/// Triangles whose angle at p has a sine below this have no normal worth the name: coordinates
/// stored as floats make all collinear samples of a lattice such triangles.
inline constexpr double degenerate_sine = 0.01;

/// (3.2), (3.3) for at most 64 neighbors. p is none of them; neighbors at p are skipped.
/// `map` is overwritten; keeping it between calls avoids allocation.
void compute_gauss_map(const Vec3& p, std::span<const Vec3> neighbors, GaussMap& map);

/// Line that the normals gather around and how far they spread from it (flatness test).
struct NormalSpread {
  Vec3 axis;  // unit; the principal direction of the normals, sign arbitrary
  double spread =
      0;  // [rad] in [0, pi/2]: arcsine of the root mean square sine of their angles to it
};

/// Of an empty map: axis z, spread 0.
NormalSpread normal_spread(const GaussMap& map);

}  // namespace spigolo
