// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/index/summary.cpp
#include "spigolo/index/summary.h"

#include "spigolo/index/neighborhoods.h"
#include "spigolo/index/noise.h"
#include "spigolo/index/order.h"
#include "spigolo/index/spacing.h"

namespace spigolo {

CloudSummary summarize(std::span<const Vec3> points, const Job& job) {
  constexpr std::size_t k = 16;  // what the noise estimate looks at
  const OrderedCloud cloud = order_cloud(points, job);
  const KdTree tree(cloud);
  const Neighborhoods neighborhoods = find_neighborhoods(tree, k, job);
  const Spacing spacing = estimate_spacing(cloud.points, neighborhoods, job);
  CloudSummary summary;
  summary.points = points.size();
  summary.distinct = cloud.size();
  summary.duplicates = cloud.duplicates;
  summary.non_finite = cloud.non_finite;
  summary.bounds = bounding_box(points);
  summary.spacing = spacing.of_cloud;
  summary.noise = estimate_noise(cloud.points, neighborhoods, spacing, tree, job);
  return summary;
}

}  // namespace spigolo
