// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/sample_mesh.cpp
#include "sample_mesh.h"

#include <algorithm>

#include "spigolo/core/random.h"

namespace spigolo::bench {

std::vector<Vec3> sample_mesh(const TriangleMesh& mesh, std::size_t count, std::uint64_t seed) {
  const std::vector<Vec3>& v = mesh.vertices.points;
  std::vector<double> area_up_to;
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    area_up_to.push_back(area += norm(cross(v[b] - v[a], v[c] - v[a])) / 2);
  Random random(seed);
  std::vector<Vec3> samples;
  while (samples.size() < count) {
    const auto it = std::upper_bound(area_up_to.begin(), area_up_to.end(), random.uniform(0, area));
    const auto t =
        std::min(static_cast<std::size_t>(it - area_up_to.begin()), area_up_to.size() - 1);
    const auto [a, b, c] = mesh.triangles[t];
    const double r = std::sqrt(random.uniform()), s = random.uniform();
    samples.push_back(v[a] * (1 - r) + v[b] * (r * (1 - s)) + v[c] * (r * s));
  }
  return samples;
}

}  // namespace spigolo::bench
