// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/check.cpp
#include "spigolo/mesh/check.h"

#include <algorithm>

#include "spigolo/core/parity_sets.h"

namespace spigolo {
namespace {

// Counts the sets among the elements that are used.
std::size_t count_sets(ParitySets& sets, const std::vector<char>& used) {
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < used.size(); ++i)
    if (used[i] && sets.find(i).set == i) ++count;
  return count;
}

void count_edges(const EdgeTable& table, MeshCheck& check) {
  check.edges = table.edges.size();
  for (const MeshEdge& edge : table.edges) {
    if (edge.count == 1) ++check.border_edges;
    if (edge.count > 2) ++check.nonmanifold_edges;
  }
}

void count_misoriented(const EdgeTable& table, std::span<const Triangle> triangles,
                       MeshCheck& check) {
  const auto from = [&](std::uint32_t half) { return triangles[half / 3][half % 3]; };
  for (const MeshEdge& edge : table.edges)
    if (edge.count == 2 && from(table.of(edge)[0]) == from(table.of(edge)[1]))
      ++check.misoriented_edges;
}

void count_components(std::size_t vertices, std::span<const Triangle> triangles,
                      const EdgeTable& table, MeshCheck& check) {
  ParitySets all(vertices), borders(vertices);
  std::vector<char> used(vertices, 0), on_border(vertices, 0);
  for (const auto& [a, b, c] : triangles) {
    used[a] = used[b] = used[c] = 1;
    all.join(a, b);
    all.join(b, c);
  }
  for (const MeshEdge& edge : table.edges) {
    if (edge.count != 1) continue;
    on_border[edge.low] = on_border[edge.high] = 1;
    borders.join(edge.low, edge.high);
  }
  check.vertices = static_cast<std::size_t>(std::count(used.begin(), used.end(), 1));
  check.components = count_sets(all, used);
  check.border_loops = count_sets(borders, on_border);
}

void measure_triangles(std::span<const Vec3> points, std::span<const Triangle> triangles,
                       MeshCheck& check) {
  const Vec3 center = bounding_box(points).center();
  double area = 0, volume = 0;
  for (const auto& [i, j, k] : triangles) {
    const Vec3 a = points[i] - center, b = points[j] - center, c = points[k] - center;
    if (is_degenerate(a, b, c)) ++check.degenerate;
    area += norm(cross(b - a, c - a)) / 2;
    volume += dot(a, cross(b, c)) / 6;
  }
  check.area = area;
  if (check.closed() && check.oriented()) check.volume = volume;
}

}  // namespace

MeshCheck check_connections(const TriangleMesh& mesh, std::span<const VertexPair> creases,
                            const Job& job) {
  const std::span<const Vec3> points = mesh.vertices.points;
  const std::span<const Triangle> triangles = mesh.triangles;
  MeshCheck check;
  check.triangles = triangles.size();
  check.crease_edges = creases.size();
  const EdgeTable table = find_edges(points.size(), triangles, job);
  count_edges(table, check);
  count_misoriented(table, triangles, check);
  count_components(points.size(), triangles, table, check);
  check.nonmanifold_vertices = find_fan_vertices(points.size(), triangles, table).size();
  check.euler = static_cast<long long>(check.vertices) - static_cast<long long>(check.edges) +
                static_cast<long long>(check.triangles);
  measure_triangles(points, triangles, check);
  for (const auto& [a, b] : creases)
    if (table.find(a, b)) ++check.crease_edges_kept;
  return check;
}

MeshCheck check_mesh(const TriangleMesh& mesh, std::span<const VertexPair> creases,
                     const Job& job) {
  MeshCheck check = check_connections(mesh, creases, job);
  check.self_intersections =
      find_self_intersections(mesh.vertices.points, mesh.triangles, job).size();
  return check;
}

}  // namespace spigolo
