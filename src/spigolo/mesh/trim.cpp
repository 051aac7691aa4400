// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/trim.cpp
#include "spigolo/mesh/trim.h"

#include <algorithm>

#include "spigolo/core/parity_sets.h"

namespace spigolo {
namespace {

constexpr double longest = 3.0;  // [edges] of a triangle between samples
const double steepest = radians(55);

// Groups of triangles that share edges with two triangles; `take` says which triangles count.
template <class Take>
ParitySets group(const std::vector<Triangle>& triangles, std::size_t vertices, const Take& take) {
  ParitySets groups(triangles.size());
  for (const EdgeTable table = find_edges(vertices, triangles);
       const MeshEdge& edge : table.edges) {
    const auto halves = table.of(edge);
    for (std::size_t i = 1; i < halves.size(); ++i)
      if (take(halves[0] / 3) && take(halves[i] / 3)) groups.join(halves[0] / 3, halves[i] / 3);
  }
  return groups;
}

void keep(std::vector<Triangle>& triangles, const std::vector<char>& kept) {
  std::size_t n = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (kept[t]) triangles[n++] = triangles[t];
  triangles.resize(n);
}

}  // namespace

void drop_scraps(std::vector<Triangle>& triangles, std::size_t vertices, std::size_t least) {
  ParitySets pieces = group(triangles, vertices, [](std::size_t) { return true; });
  std::vector<std::uint32_t> size(triangles.size(), 0);
  for (std::uint32_t t = 0; t < triangles.size(); ++t) ++size[pieces.find(t).set];
  std::vector<char> kept(triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) kept[t] = size[pieces.find(t).set] >= least;
  keep(triangles, kept);
}

std::size_t trim_unsupported(std::vector<Triangle>& triangles, const MeshSamples& samples,
                             const Openness& openness, const TrimOptions& options) {
  const std::size_t before = triangles.size();
  std::vector<char> open(triangles.size()), far(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    far[t] = openness.length(triangles[t]) > longest;
    open[t] = far[t] || openness.tilt(triangles[t]) > steepest;
  }
  ParitySets groups = group(triangles, samples.size(), [&](std::size_t t) { return open[t] != 0; });
  std::vector<Box> box(triangles.size());  // of the long triangles of a group
  std::vector<char> bridged(triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    if (!open[t]) continue;
    const std::uint32_t set = groups.find(t).set;
    if (!far[t]) continue;
    bridged[set] = 1;
    for (const std::uint32_t v : triangles[t]) box[set].add(samples.position[v]);
  }
  std::vector<char> kept(triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const std::uint32_t set = groups.find(t).set;
    kept[t] =
        !open[t] || !bridged[set] || norm(box[set].size()) <= options.largest_hole * samples.step;
  }
  keep(triangles, kept);
  if (triangles.size() < before) drop_scraps(triangles, samples.size(), options.least_piece);
  return before - triangles.size();
}

std::size_t take_faults(std::vector<Triangle>& triangles, const std::vector<Vec3>& points,
                        const Job& job) {
  std::vector<char> kept(triangles.size(), 1);
  const EdgeTable table = find_edges(points.size(), triangles, job);
  const auto from = [&](std::uint32_t half) { return triangles[half / 3][half % 3]; };
  for (const MeshEdge& edge : table.edges) {
    const auto halves = table.of(edge);
    const bool fault = edge.count > 2 || (edge.count == 2 && from(halves[0]) == from(halves[1]));
    for (const std::uint32_t half : halves)
      if (fault) kept[half / 3] = 0;
  }
  for (const auto& pair : find_self_intersections(points, triangles, job))
    for (const std::uint32_t t : pair) kept[t] = 0;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (is_degenerate(points[triangles[t][0]], points[triangles[t][1]], points[triangles[t][2]]))
      kept[t] = 0;
  const std::size_t before = triangles.size();
  keep(triangles, kept);
  if (triangles.size() < before) drop_scraps(triangles, points.size(), TrimOptions{}.least_piece);
  return before - triangles.size();
}

}  // namespace spigolo
