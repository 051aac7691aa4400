// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/detect/gauss_map_method.cpp - thesis chapter 3
#include <algorithm>

#include "spigolo/detect/methods.h"
#include "spigolo/gauss_map/adapt.h"

namespace spigolo {
namespace {

// The thesis starts with sigma 0.1 rad, which holds without noise; with noise the normals of one
// sheet spread wider than that and neither it nor the smallest cluster can stay
// (docs/detection.md).
FeatureTestOptions for_noise(double noise, const DetectOptions& given) {
  struct Row {
    double up_to, sigma, min_cluster;  // [spacings], [rad], share
  };
  constexpr Row rows[] = {{0.03, 0.1, 0.15}, {0.1, 0.6, 0.18}, {infinity, 0.9, 0.22}};
  const Row& row = *std::find_if(std::begin(rows), std::end(rows),
                                 [&](const Row& r) { return noise <= r.up_to; });
  FeatureTestOptions test;
  test.sigma = given.sigma == from_noise ? row.sigma : given.sigma;
  test.min_cluster = given.min_cluster == from_noise ? row.min_cluster : given.min_cluster;
  test.flatness = given.flatness;
  return test;
}

Features in_canonical_order(const OrderedCloud& cloud, const Neighborhoods& neighborhoods,
                            std::size_t k, const GaussMapFeatures& found) {
  Features features;
  features.assign_surface(cloud.size());
  std::vector<Vec3> neighbors;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const FeatureTest& test = found.test[i];
    if (test.verdict != FeatureVerdict::sharp) continue;
    neighbors.clear();
    for (const std::uint32_t j : neighborhoods.of(i).first(k)) neighbors.push_back(cloud.points[j]);
    features.kind[i] = test.clusters == 2 ? PointKind::edge : PointKind::corner;
    features.angle[i] = edge_deviation(cloud.points[i], neighbors, test.normal);
    // A point right on an edge has a quarter of its triangles in each sheet.
    features.strength[i] = static_cast<float>(std::clamp(test.second_share / 0.25, 0.01, 1.0));
    features.crease_point[i] = cloud.points[i];  // every triangle holds the point
  }
  return features;
}

}  // namespace

Features features_by_gauss_map(const PreparedCloud& prepared, const DetectOptions& options,
                               const Job& job, Detection& result) {
  const std::span<const Vec3> points = prepared.cloud.points;
  const FeatureTestOptions test = for_noise(prepared.noise, options);
  result.k = neighbors_at_hand(prepared, options.k, result.warnings);
  result.sigma = test.sigma;
  result.min_cluster = test.min_cluster;
  AdaptOptions adapt;
  adapt.k = result.k;
  adapt.test = test;
  const GaussMapFeatures found =
      options.method == DetectMethod::gauss_map
          ? detect_adaptive(points, prepared.neighborhoods, adapt, job)
          : detect_global(points, prepared.neighborhoods, result.k, test, job);
  result.candidates = found.candidates;
  result.degenerate = found.degenerate;
  return in_canonical_order(prepared.cloud, prepared.neighborhoods, result.k, found);
}

}  // namespace spigolo
