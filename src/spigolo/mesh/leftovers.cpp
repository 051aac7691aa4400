// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/leftovers.cpp
#include "spigolo/mesh/leftovers.h"

#include <algorithm>

#include "spigolo/mesh/point_cells.h"

namespace spigolo {
namespace {

constexpr double passed_by = 1.6;         // [edges] a sample farther from all vertices is left out
constexpr double beside = 2.6;            // [edges] unused samples nearer to those go with them
constexpr double flying = 2.0;            // [steps] samples that far apart begin no sheet
constexpr std::size_t least_sheet = 24;   // samples; fewer are no sheet
constexpr double covered_distance = 2.0;  // [edges] from a point of the cloud to a vertex, times
constexpr double sparsest = 2.0;          // at most that where the cloud is sparse

std::vector<char> used_vertices(std::size_t count, const std::vector<Triangle>& triangles) {
  std::vector<char> used(count, 0);
  for (const Triangle& t : triangles)
    for (const std::uint32_t v : t) used[v] = 1;
  return used;
}

bool any_near(const PointCells& cells, const Vec3& p, double r) {
  return cells.any_within(p, r, [](std::uint32_t, double) { return true; });
}

}  // namespace

std::vector<std::uint32_t> left_out(const MeshSamples& samples,
                                    const std::vector<Triangle>& triangles) {
  const std::vector<char> used = used_vertices(samples.size(), triangles);
  PointCells vertices(beside * samples.step, samples.size());
  for (std::size_t v = 0; v < samples.size(); ++v)
    if (used[v]) vertices.insert(samples.position[v]);
  PointCells away(beside * samples.step, samples.size());
  for (std::size_t v = samples.on_creases; v < samples.size(); ++v)
    if (!used[v] && samples.length[v] <= flying * samples.step &&
        !any_near(vertices, samples.position[v], passed_by * samples.length[v]))
      away.insert(samples.position[v]);
  if (away.points().size() < least_sheet) return {};
  std::vector<std::uint32_t> which;
  for (std::size_t v = samples.on_creases; v < samples.size(); ++v)
    if (!used[v] && any_near(away, samples.position[v], beside * samples.length[v]))
      which.push_back(static_cast<std::uint32_t>(v));
  return which;
}

MeshSamples take_samples(const MeshSamples& samples, const CreaseSides& sides,
                         const std::vector<std::uint32_t>& which) {
  std::vector<std::uint32_t> number(samples.size(), no_index);
  for (const std::uint32_t v : which) number[v] = 0;
  std::vector<std::size_t> segments;
  std::vector<char> taken(samples.on_creases, 0);
  for (std::size_t s = 0; s < samples.creases.size(); ++s) {
    const SegmentSides& side = sides.of_segment[s];
    if (!side.known ||
        (number[side.shown_by[0]] == no_index && number[side.shown_by[1]] == no_index))
      continue;
    segments.push_back(s);
    for (const std::uint32_t v : samples.creases[s]) taken[v] = 1;
  }
  MeshSamples part;
  part.step = samples.step;
  const auto add = [&](std::uint32_t v) {
    number[v] = static_cast<std::uint32_t>(part.size());
    part.position.push_back(samples.position[v]);
    part.normal.push_back(samples.normal[v]);
    part.length.push_back(samples.length[v]);
  };
  for (std::uint32_t v = 0; v < samples.on_creases; ++v)
    if (taken[v]) add(v);
  part.on_creases = part.size();
  for (const std::uint32_t v : which) add(v);
  for (const std::size_t s : segments) {
    part.creases.push_back({number[samples.creases[s][0]], number[samples.creases[s][1]]});
    part.curve.push_back(samples.curve[s]);
  }
  return part;
}

std::size_t count_uncovered(const SurfacePoints& surface, const std::vector<Vec3>& vertices,
                            const std::vector<Triangle>& triangles, double step) {
  const std::vector<char> used = used_vertices(vertices.size(), triangles);
  PointCells cells(covered_distance * step, vertices.size());
  for (std::size_t v = 0; v < vertices.size(); ++v)
    if (used[v]) cells.insert(vertices[v]);
  std::size_t count = 0;
  for (const SurfaceFoot& foot : surface.points) {
    const double sparse = std::clamp(foot.spacing / surface.spacing, 1.0, sparsest);
    if (foot.valid() && !any_near(cells, foot.position, covered_distance * step * sparse)) ++count;
  }
  for (const Vec3& p : surface.loose)
    if (!any_near(cells, p, covered_distance * step)) ++count;
  return count;
}

}  // namespace spigolo
