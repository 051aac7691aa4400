// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/measure/distance.cpp - distances to the nearest point and to the nearest triangle
#include "spigolo/measure/distance.h"

#include <cmath>
#include <optional>

#include "spigolo/core/error.h"
#include "spigolo/core/parallel.h"
#include "spigolo/index/kd_tree.h"
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

BoxTree triangle_tree(const std::vector<Vec3>& v, const std::vector<Triangle>& triangles,
                      const Job& job) {
  std::vector<Box> boxes(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (const std::uint32_t corner : triangles[i]) boxes[i].add(v[corner]);
  return BoxTree(boxes, job);
}

// The index of the first point at each place.
std::vector<std::size_t> first_at_place(const OrderedCloud& cloud) {
  std::vector<std::size_t> first(cloud.size());
  for (std::size_t i = cloud.rank.size(); i-- > 0;)
    if (cloud.rank[i] != no_point) first[cloud.rank[i]] = i;
  return first;
}

// The distance of every point, NaN where it is not finite. Points that lie together are measured
// together, which finds their way through the tree in the cache; equal ones are measured once.
// make_measure: called once a range, so that what it returns can keep scratch memory.
template <class MakeMeasure>
std::vector<double> by_place(std::span<const Vec3> points, const Job& job,
                             const MakeMeasure& make_measure) {
  const OrderedCloud cloud = order_cloud(points, job);
  const std::vector<std::size_t> first = first_at_place(cloud);
  std::vector<double> at_place(cloud.size());
  parallel_for(job, "distances", cloud.size(), grain, [&](std::size_t begin, std::size_t end) {
    auto measure = make_measure();
    for (std::size_t r = begin; r < end; ++r) at_place[r] = measure(points[first[r]]);
  });
  std::vector<double> result(points.size(), not_a_number);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (cloud.rank[i] != no_point) result[i] = at_place[cloud.rank[i]];
  return result;
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
  const OrderedCloud targets = order_cloud(to, job);
  if (targets.size() == 0) throw NoResultError("there is no point to measure distances to");
  const KdTree tree(targets);
  const std::vector<std::size_t> first = first_at_place(targets);
  return by_place(points, job, [&] {
    return [&, found = std::vector<Neighbor>()](const Vec3& p) mutable {
      tree.nearest(p - targets.origin, 1, found);
      return distance(p, to[first[found.front().index]]);  // without the rounding of the origin
    };
  });
}

std::vector<double> distances_to_segments(std::span<const Vec3> points,
                                          std::span<const Vec3> vertices, const Segments& segments,
                                          const Job& job) {
  std::vector<std::array<Vec3, 2>> ends;
  std::vector<Box> boxes;
  for (const auto& [i, j] : segments) {
    if (!is_finite(vertices[i]) || !is_finite(vertices[j])) continue;
    ends.push_back({vertices[i], vertices[j]});
    boxes.emplace_back();
    for (const Vec3& end : ends.back()) boxes.back().add(end);
  }
  if (ends.empty()) throw NoResultError("there is no line to measure distances to");
  const BoxTree tree(boxes, job);
  ends = in_slots(tree, ends);
  return by_place(points, job, [&] {
    return [&](const Vec3& p) {
      const auto near = tree.nearest(p, [&](std::size_t slot) {
        const auto& [a, b] = ends[slot];
        const Vec3 along = b - a;
        const double squared = squared_norm(along);
        const double t = squared > 0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
        return squared_distance(p, a + along * t);
      });
      return std::sqrt(near.squared_distance);
    };
  });
}

std::vector<double> distances_to_mesh(std::span<const Vec3> points, const TriangleMesh& mesh,
                                      bool with_sign, const Job& job) {
  const std::vector<Vec3>& v = mesh.vertices.points;
  std::vector<Triangle> triangles = measurable(mesh);
  const BoxTree tree = triangle_tree(v, triangles, job);
  triangles = in_slots(tree, triangles);
  std::optional<PseudoNormals> normals;
  if (with_sign) normals.emplace(v, triangles);
  auto foot = [&](const Vec3& p, std::size_t f) {
    const Triangle& t = triangles[f];
    return nearest_on_triangle(p, v[t[0]], v[t[1]], v[t[2]]);
  };
  return by_place(points, job, [&] {
    return [&](const Vec3& p) {
      const auto near =
          tree.nearest(p, [&](std::size_t f) { return squared_distance(p, foot(p, f).point); });
      const double size = std::sqrt(near.squared_distance);
      if (!normals) return size;
      const TriangleFoot q = foot(p, near.slot);
      return dot(p - q.point, normals->at(near.slot, q.part)) < 0 ? -size : size;
    };
  });
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
