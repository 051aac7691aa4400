// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/gauss_map/feature_test.cpp
#include "spigolo/gauss_map/feature_test.h"

#include <algorithm>
#include <cmath>

#include "spigolo/core/symmetric3.h"

namespace spigolo {
namespace {

// Principal direction of the normals in one cluster.
Vec3 cluster_normal(const GaussMap& map, const Clustering& clustering, std::uint32_t cluster) {
  Symmetric3 m;
  for (std::size_t t = 0; t < map.size; ++t) {
    if (clustering.cluster[t] == cluster) m.add(map.normal(t));
  }
  return largest_axis(m).axis;
}

// The two largest clusters, the first of equals, and how many are large enough to count.
struct Significant {
  int count = 0;
  std::array<std::uint32_t, 2> largest{};
};

Significant significant_clusters(const Clustering& clustering, double smallest) {
  Significant result;
  std::array<std::uint32_t, 2> size{};
  for (std::uint32_t c = 0; c < clustering.size.size(); ++c) {
    const std::uint32_t s = clustering.size[c];
    result.count += s >= smallest;
    if (s > size[0]) {
      size = {s, size[0]};
      result.largest = {c, result.largest[0]};
    } else if (s > size[1]) {
      size[1] = s;
      result.largest[1] = c;
    }
  }
  return result;
}

}  // namespace

FeatureTest test_point(const Vec3& p, std::span<const Vec3> neighbors,
                       const FeatureTestOptions& options, FeatureTestScratch& scratch) {
  FeatureTest result;
  compute_gauss_map(p, neighbors, scratch.map);  // (3.2), (3.3)
  const std::size_t triangles = scratch.map.size;
  if (triangles < 3) return result;
  result.verdict = FeatureVerdict::flat;
  if (normal_spread(scratch.map).spread < options.flatness * half_pi) return result;
  const double smallest = std::max(2.0, options.min_cluster * static_cast<double>(triangles));
  // A cluster so large that no second one can be: the point is smooth, whatever else would merge.
  const auto dominant = static_cast<std::size_t>(static_cast<double>(triangles) - smallest) + 1;
  cluster_normals(scratch.map, options.sigma, scratch.clustering, dominant);  // (3.4), (3.5)
  const Significant significant = significant_clusters(scratch.clustering, smallest);
  result.clusters = significant.count;
  result.verdict = FeatureVerdict::smooth;
  if (significant.count < 2 || significant.count > options.max_clusters) return result;
  result.verdict = FeatureVerdict::sharp;
  for (std::size_t c = 0; c < 2; ++c)
    result.normal[c] = cluster_normal(scratch.map, scratch.clustering, significant.largest[c]);
  result.second_share =
      scratch.clustering.size[significant.largest[1]] / static_cast<double>(triangles);
  return result;
}

double edge_deviation(const Vec3& p, std::span<const Vec3> neighbors,
                      const std::array<Vec3, 2>& normal) {
  const Vec3 along = normalized(cross(normal[0], normal[1]));
  if (along == Vec3{}) return 0;
  std::array<Vec3, 2> half_plane{};  // where the neighbors of each sheet are, across the edge
  for (const Vec3& neighbor : neighbors) {
    const Vec3 e = neighbor - p, across = e - along * dot(e, along);
    const double off0 = std::abs(dot(e, normal[0])), off1 = std::abs(dot(e, normal[1]));
    if (off0 != off1) half_plane[off0 < off1 ? 0 : 1] += across;
  }
  for (std::size_t s = 0; s < 2; ++s) half_plane[s] -= normal[s] * dot(half_plane[s], normal[s]);
  if (half_plane[0] == Vec3{} || half_plane[1] == Vec3{}) return axial_angle(normal[0], normal[1]);
  return pi - angle_between(half_plane[0], half_plane[1]);
}

}  // namespace spigolo
