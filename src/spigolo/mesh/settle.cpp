// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/settle.cpp
#include "spigolo/mesh/settle.h"

#include <algorithm>

#include "spigolo/mesh/check.h"

namespace spigolo {
namespace {

constexpr int most_rounds = 8;  // each goes a ring of triangles farther where it has to

std::vector<std::uint32_t> faults(std::span<const Triangle> triangles,
                                  const std::vector<Vec3>& points, const Job& job) {
  std::vector<std::uint32_t> found;
  for (const auto& pair : find_self_intersections(points, triangles, job))
    found.insert(found.end(), pair.begin(), pair.end());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    if (is_degenerate(points[a], points[b], points[c])) found.push_back(t);
  }
  return found;
}

}  // namespace

std::size_t settle(std::span<const Triangle> triangles, std::vector<Vec3>& points,
                   const std::function<Vec3(std::uint32_t)>& safe, const Job& job) {
  std::vector<char> moved(points.size(), 0);
  for (int round = 0; round < most_rounds; ++round) {
    const std::vector<std::uint32_t> bad = faults(triangles, points, job);
    if (bad.empty()) break;
    std::vector<char> next = moved;
    for (const std::uint32_t t : bad)
      for (const std::uint32_t v : triangles[t]) next[v] = 1;
    if (next == moved)  // what they run into is around
      for (const Triangle& t : triangles)
        if (std::any_of(t.begin(), t.end(), [&](std::uint32_t v) { return moved[v] != 0; }))
          for (const std::uint32_t v : t) next[v] = 1;
    for (std::uint32_t v = 0; v < points.size(); ++v)
      if (next[v] && !moved[v]) points[v] = safe(v);
    moved = std::move(next);
  }
  return static_cast<std::size_t>(std::count(moved.begin(), moved.end(), 1));
}

}  // namespace spigolo
