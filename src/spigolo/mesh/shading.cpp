// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/shading.cpp
#include "spigolo/mesh/shading.h"

#include <algorithm>

#include "spigolo/core/parity_sets.h"
#include "spigolo/mesh/edges.h"

namespace spigolo {
namespace {

std::vector<VertexPair> sorted(std::span<const VertexPair> creases) {
  std::vector<VertexPair> all(creases.begin(), creases.end());
  for (VertexPair& pair : all)
    if (pair[0] > pair[1]) std::swap(pair[0], pair[1]);
  std::sort(all.begin(), all.end());
  return all;
}

// Calls visit(half, half) for the two sides of every edge that is no crease.
template <class Visit>
void across_smooth_edges(const EdgeTable& table, const std::vector<VertexPair>& creases,
                         const Visit& visit) {
  for (const MeshEdge& edge : table.edges) {
    if (edge.count != 2) continue;
    if (std::binary_search(creases.begin(), creases.end(), VertexPair{edge.low, edge.high}))
      continue;
    const auto halves = table.of(edge);
    visit(edge, halves[0], halves[1]);
  }
}

}  // namespace

std::vector<std::uint32_t> find_patches(const TriangleMesh& mesh,
                                        std::span<const VertexPair> creases) {
  ParitySets sets(mesh.triangles.size());
  const EdgeTable table = find_edges(mesh.vertices.size(), mesh.triangles);
  across_smooth_edges(
      table, sorted(creases),
      [&](const MeshEdge&, std::uint32_t a, std::uint32_t b) { sets.join(a / 3, b / 3); });
  std::vector<std::uint32_t> number(mesh.triangles.size(), no_index), patch;
  std::uint32_t count = 0;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    std::uint32_t& n = number[sets.find(t).set];
    if (n == no_index) n = count++;
    patch.push_back(n);
  }
  return patch;
}

std::vector<std::array<Vec3, 3>> corner_normals(const TriangleMesh& mesh,
                                                std::span<const VertexPair> creases) {
  const auto& triangles = mesh.triangles;
  const auto& points = mesh.vertices.points;
  ParitySets fans(3 * triangles.size());  // corners
  const EdgeTable table = find_edges(points.size(), triangles);
  const auto corner_at = [&](std::uint32_t half, std::uint32_t v) {
    return triangles[half / 3][half % 3] == v ? half : next_half(half);
  };
  across_smooth_edges(table, sorted(creases),
                      [&](const MeshEdge& edge, std::uint32_t a, std::uint32_t b) {
                        for (const std::uint32_t v : {edge.low, edge.high})
                          fans.join(corner_at(a, v), corner_at(b, v));
                      });
  std::vector<Vec3> sum(3 * triangles.size());
  for (std::uint32_t c = 0; c < sum.size(); ++c) {
    const Triangle& t = triangles[c / 3];
    const Vec3& p = points[t[c % 3]];
    const Vec3 a = points[t[(c + 1) % 3]] - p, b = points[t[(c + 2) % 3]] - p;
    sum[fans.find(c).set] += angle_between(a, b) * normalized(cross(a, b));
  }
  std::vector<std::array<Vec3, 3>> normals(triangles.size());
  for (std::uint32_t c = 0; c < sum.size(); ++c)
    normals[c / 3][c % 3] = normalized(sum[fans.find(c).set]);
  return normals;
}

}  // namespace spigolo
