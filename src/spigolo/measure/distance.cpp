// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/measure/distance.cpp - distances to the nearest point and to the nearest triangle
#include "spigolo/measure/distance.h"

#include <memory>
#include <optional>

#include "spigolo/core/error.h"
#include "spigolo/core/parallel.h"
#include "spigolo/measure/box_tree.h"
#include "spigolo/measure/pseudo_normals.h"
#include "spigolo/measure/triangle_distance.h"

namespace spigolo {
namespace {

constexpr std::size_t grain = 1024;

using Triangle = std::array<std::uint32_t, 3>;

bool has_area(const std::vector<Vec3>& v, const Triangle& t) {
  const Vec3 normal = cross(v[t[1]] - v[t[0]], v[t[2]] - v[t[0]]);
  return is_finite(normal) && squared_norm(normal) > 0;
}

std::vector<Triangle> measurable(const TriangleMesh& mesh) {
  std::vector<Triangle> kept;
  for (const Triangle& t : mesh.triangles)
    if (has_area(mesh.vertices.points, t)) kept.push_back(t);
  if (kept.empty()) throw NoResultError("the mesh has no triangle with area to measure to");
  return kept;
}

/// The data of the tree's items in the order of its slots.
template <class T>
std::vector<T> in_slots(const BoxTree& tree, const std::vector<T>& data) {
  std::vector<T> result;
  result.reserve(data.size());
  for (const std::uint32_t item : tree.items()) result.push_back(data[item]);
  return result;
}

BoxTree triangle_tree(const std::vector<Vec3>& v, const std::vector<Triangle>& triangles) {
  std::vector<Box> boxes(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (const std::uint32_t corner : triangles[i]) boxes[i].add(v[corner]);
  return BoxTree(boxes);
}

}  // namespace

DistanceStats summarize(std::span<const double> distances) {
  DistanceStats stats;
  std::vector<double> sizes;
  double squares = 0;
  for (const double d : distances) {
    if (!std::isfinite(d)) continue;
    sizes.push_back(std::abs(d));
    stats.mean += std::abs(d), stats.signed_mean += d, squares += d * d;
  }
  stats.count = sizes.size(), stats.skipped = distances.size() - sizes.size();
  if (sizes.empty()) return stats;
  const auto n = static_cast<double>(sizes.size());
  stats.mean /= n, stats.signed_mean /= n, stats.rms = std::sqrt(squares / n);
  const std::size_t rank = (95 * sizes.size() + 99) / 100 - 1;
  std::nth_element(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(rank), sizes.end());
  stats.p95 = sizes[rank];
  stats.max = *std::max_element(sizes.begin(), sizes.end());
  return stats;
}

double share_within(std::span<const double> distances, double tolerance) {
  std::size_t finite = 0, within = 0;
  for (const double d : distances) {
    finite += std::isfinite(d);
    within += std::abs(d) <= tolerance;
  }
  return finite == 0 ? 0 : static_cast<double>(within) / static_cast<double>(finite);
}

std::vector<double> distances_to_points(std::span<const Vec3> points, std::span<const Vec3> to,
                                        const Job& job) {
  std::vector<Vec3> targets;
  std::vector<Box> boxes;
  for (const Vec3& q : to)
    if (is_finite(q)) targets.push_back(q), boxes.push_back({q, q});
  if (targets.empty()) throw NoResultError("there is no point to measure distances to");
  const BoxTree tree(boxes);
  targets = in_slots(tree, targets);
  std::vector<double> result(points.size(), not_a_number);
  parallel_for(job, "distances", points.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vec3& p = points[i];
      if (!is_finite(p)) continue;
      const auto near =
          tree.nearest(p, [&](std::size_t j) { return squared_distance(p, targets[j]); });
      result[i] = std::sqrt(near.squared_distance);
    }
  });
  return result;
}

std::vector<double> distances_to_mesh(std::span<const Vec3> points, const TriangleMesh& mesh,
                                      bool with_sign, const Job& job) {
  const std::vector<Vec3>& v = mesh.vertices.points;
  std::vector<Triangle> triangles = measurable(mesh);
  const BoxTree tree = triangle_tree(v, triangles);
  triangles = in_slots(tree, triangles);
  std::optional<PseudoNormals> normals;
  if (with_sign) normals.emplace(v, triangles);
  auto foot = [&](const Vec3& p, std::size_t f) {
    const Triangle& t = triangles[f];
    return nearest_on_triangle(p, v[t[0]], v[t[1]], v[t[2]]);
  };
  std::vector<double> result(points.size(), not_a_number);
  parallel_for(job, "distances", points.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vec3& p = points[i];
      if (!is_finite(p)) continue;
      const auto near =
          tree.nearest(p, [&](std::size_t f) { return squared_distance(p, foot(p, f).point); });
      result[i] = std::sqrt(near.squared_distance);
      if (!normals) continue;
      const TriangleFoot q = foot(p, near.slot);
      if (dot(p - q.point, normals->at(near.slot, q.part)) < 0) result[i] = -result[i];
    }
  });
  return result;
}

Comparison compare(std::span<const Vec3> a, std::span<const Vec3> b, const Job& job) {
  return {summarize(distances_to_points(a, b, job)), summarize(distances_to_points(b, a, job))};
}

Comparison compare(std::span<const Vec3> a, const TriangleMesh& b, const Job& job) {
  std::vector<bool> used(b.vertices.size(), false);
  for (const Triangle& t : b.triangles)
    for (const std::uint32_t corner : t) used[corner] = true;
  std::vector<Vec3> corners;
  for (std::size_t i = 0; i < used.size(); ++i)
    if (used[i]) corners.push_back(b.vertices.points[i]);
  return {summarize(distances_to_mesh(a, b, true, job)),
          summarize(distances_to_points(corners, a, job))};
}

}  // namespace spigolo
