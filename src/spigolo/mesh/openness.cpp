// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/openness.cpp
#include "spigolo/mesh/openness.h"

#include <algorithm>

namespace spigolo {

double Openness::tilt(const Triangle& corners) const {
  const Vec3 &a = samples_.position[corners[0]], &b = samples_.position[corners[1]],
             &c = samples_.position[corners[2]];
  const Vec3 n = normalized(cross(b - a, c - a));
  if (!(squared_norm(n) > 0)) return half_pi;
  double largest = 0;
  for (const std::uint32_t v : corners) {
    double cosine = 0;
    if (samples_.on_crease(v)) {
      const SideNormals& side = sides_.of_vertex[v];
      if (side.count == 0) continue;
      for (std::size_t i = 0; i < side.count; ++i)
        cosine = std::max(cosine, std::abs(dot(n, side.normal[i])));
    } else {
      cosine = std::abs(dot(n, samples_.normal[v]));
    }
    largest = std::max(largest, std::acos(std::min(cosine, 1.0)));
  }
  return largest;
}

double Openness::length(const Triangle& corners) const {
  const Vec3 &a = samples_.position[corners[0]], &b = samples_.position[corners[1]],
             &c = samples_.position[corners[2]];
  return std::sqrt(
             std::max({squared_distance(a, b), squared_distance(b, c), squared_distance(c, a)})) /
         std::max({samples_.length[corners[0]], samples_.length[corners[1]],
                   samples_.length[corners[2]]});
}

double Openness::of(std::uint32_t tet, std::size_t facet) const {
  Triangle corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint32_t v = delaunay_.tetrahedra()[tet].v[facet_corners[facet][k]];
    if (v < Delaunay::helpers) return infinity;
    corners[k] = v - Delaunay::helpers;
  }
  return tilt(corners) / half_pi + std::max(0.0, length(corners) - 1) / 4;
}

}  // namespace spigolo
