// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mls/sharp_neighborhood.h - moving least squares with the neighborhood cut at the edge
// (thesis §4.3.3 to §4.3.6)
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "spigolo/core/features.h"
#include "spigolo/gauss_map/connect.h"
#include "spigolo/mls/feature_line.h"
#include "spigolo/mls/levin.h"

namespace spigolo {

/// What the cut needs to know of the cloud's features, in canonical order.
struct FeatureMap {
  std::vector<std::uint8_t> is_feature;
  ConnectedFeatures connected;
};

struct FeatureLineOptions {
  MlsOptions mls;
  double side_angle = radians(45);  // [rad] alpha of (4.5): a larger one is the other side
  bool connected = true;  // §4.3.6; false: every feature point of the neighborhood counts
};

/// kind: one label per place, in canonical order; edges, corners and tips are feature points. They
/// are connected (§4.3.6) in neighborhoods of k points. Throws UsageError if the sizes differ.
FeatureMap map_features(const MlsCloud& cloud, std::span<const PointKind> kind, std::size_t k,
                        const Job& job = {});

/// Labels of the input points, in canonical order.
std::vector<PointKind> ordered_kinds(const OrderedCloud& cloud,
                                     std::span<const PointKind> kind_of_input);

/// Memory of one thread.
struct FeatureLineScratch {
  MlsScratch mls;
  std::vector<Vec3> line_points;      // feature points that the line is made of
  std::vector<std::uint8_t> on_line;  // per neighbor: one of them
};

/// The line through the neighborhood in scratch.mls.found of p (relative to the cloud's origin), if
/// it holds four feature points of the edge nearest to p.
std::optional<FeatureLine> local_feature_line(const MlsCloud& cloud, const FeatureMap& features,
                                              const FeatureLineOptions& options,
                                              FeatureLineScratch& scratch);

/// The thesis's projection of a query in input coordinates: plain without a feature line; else only
/// neighbors on the query's side of it (4.5), the missing ones replaced by samples of the line. A
/// query on the line, or nearer to it than to what comes out, goes to the line. options.mls:
/// settled.
SurfacePoint project_feature_line(const MlsCloud& cloud, const FeatureMap& features,
                                  const Vec3& query, const FeatureLineOptions& options,
                                  FeatureLineScratch& scratch);

}  // namespace spigolo
