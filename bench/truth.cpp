// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/truth.cpp
#include "truth.h"

#include "spigolo/core/symmetric3.h"

namespace spigolo::bench {

double mean_spacing(const SynthCloud& s) {
  return std::sqrt(area(s.shape) / static_cast<double>(s.exact.size()));
}

// The direction in which the patch does not follow a point that is moved off it.
Vec3 true_normal(const Shape& shape, const Vec3& p) {
  const Patch* own = nullptr;
  double best = infinity;
  for (const Patch& patch : shape.patches)
    if (const double d = distance(p, patch.nearest(p)); d < best) best = d, own = &patch;
  const double step = 1e-5 * shape.radius;
  const Vec3 foot = own->nearest(p);
  Symmetric3 tangents;
  for (const std::size_t axis : {0u, 1u, 2u})
    for (const double sign : {-1.0, 1.0}) {
      Vec3 d;
      d[axis] = sign * step;
      tangents.add((own->nearest(foot + d) - foot) / step);
    }
  return smallest_axis(tangents).axis;
}

std::vector<Vec3> edge_places(const Shape& shape, double spacing) {
  std::vector<Vec3> places;
  for (const ExactCrease& crease : shape.creases) {
    double length = 0;
    for (int i = 0; i < 256; ++i)
      length += distance(crease.curve.at(i / 256.0), crease.curve.at((i + 1) / 256.0));
    const int steps = std::max(2, static_cast<int>(2 * length / spacing));
    for (int i = 0; i < steps; ++i) places.push_back(crease.curve.at((i + 0.5) / steps));
  }
  return places;
}

}  // namespace spigolo::bench
