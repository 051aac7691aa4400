// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/measure/classification.cpp - recall, precision, outliers; delta_inf, delta_avg
#include "spigolo/measure/classification.h"

#include "spigolo/core/error.h"
#include "spigolo/measure/distance.h"

namespace spigolo {
namespace {

constexpr double lattice_limit = 1.5;  // [spacings] where a tolerant score begins to count again
constexpr double scattered_limit = 2;

// Non-features up to so many local spacings from an edge do not count.
double ignored_up_to(const FeatureTruth& truth, Scoring scoring) {
  if (scoring == Scoring::thin) return -1;
  return truth.lattice ? lattice_limit : scattered_limit;
}

double spacing_at(const FeatureTruth& truth, std::size_t i) {
  return truth.local_spacing.empty() ? truth.spacing : truth.local_spacing[i];
}

double share(std::size_t part, std::size_t whole) {
  return whole == 0 ? 1 : static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

FeatureTruth read_truth(const PointCloud& cloud, double spacing, bool lattice) {
  const Attribute* feature = cloud.find("truth_feature");
  const Attribute* edge_distance = cloud.find("truth_edge_distance");
  if (!feature || !edge_distance)
    throw NoResultError("the cloud carries no truth_feature and truth_edge_distance to score by");
  FeatureTruth truth{{}, edge_distance->values, spacing, lattice, {}};
  if (const Attribute* local = cloud.find("truth_spacing")) truth.local_spacing = local->values;
  for (const double f : feature->values) truth.feature.push_back(f != 0);
  return truth;
}

Classification classify(std::span<const std::uint8_t> flagged, const FeatureTruth& truth,
                        Scoring scoring) {
  const bool local_too =
      truth.local_spacing.empty() || truth.local_spacing.size() == truth.feature.size();
  if (flagged.size() != truth.feature.size() || flagged.size() != truth.edge_distance.size() ||
      !local_too)
    throw UsageError("flags and truth must have one entry per point each");
  const double limit = ignored_up_to(truth, scoring);
  Classification c;
  for (std::size_t i = 0; i < flagged.size(); ++i) {
    const bool feature = truth.feature[i] != 0, flag = flagged[i] != 0;
    if (!feature && truth.edge_distance[i] <= limit * spacing_at(truth, i)) {
      ++c.ignored;
      continue;
    }
    ++c.points;
    c.features += feature;
    c.flagged += flag;
    c.hits += feature && flag;
    c.missed += feature && !flag;
    c.outliers += !feature && flag;
  }
  c.recall = share(c.hits, c.features);
  c.precision = share(c.hits, c.flagged);
  c.f1 = share(2 * c.hits, 2 * c.hits + c.missed + c.outliers);
  return c;
}

std::vector<std::uint8_t> sharp_flags(const Features& features) {
  std::vector<std::uint8_t> flags;
  flags.reserve(features.size());
  for (const PointKind kind : features.kind)
    flags.push_back(kind == PointKind::edge || kind == PointKind::corner || kind == PointKind::tip);
  return flags;
}

FeatureDeviation feature_deviation(std::span<const Vec3> estimated, std::span<const Vec3> real,
                                   const Job& job) {
  if (estimated.empty()) return {0, 0, 0, real.size()};
  const DistanceStats stats = summarize(distances_to_points(estimated, real, job));
  return {stats.max, stats.mean, estimated.size(), real.size()};
}

}  // namespace spigolo
