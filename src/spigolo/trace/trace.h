// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/trace.h - from labelled points to a network of curves and corners
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "spigolo/core/feature_curves.h"
#include "spigolo/core/features.h"
#include "spigolo/core/job.h"

namespace spigolo {

inline constexpr double automatic_tolerance = -1;

struct TraceOptions {
  double spacing = 0;  // [input units] of the cloud, > 0
  double noise = 0;    // [spacings] standard deviation across the surface
  double scatter = 0;  // [spacings] how far the crease points of the features lie off the crease;
                       // 0 for sheets without noise
  double tolerance = automatic_tolerance;  // [input units] between a spline and the curve; > 0
};

struct TracedFeatures {
  FeatureCurves network;
  std::vector<std::int32_t> curve_of_point;  // number of the curve of each point, -1: none
  double tolerance = 0;                      // [input units] used for splines
};

/// One network for the cloud: edges first, then borders. points: as given to detect(), features:
/// what it said. The network does not depend on the order of the points. Nothing found is an empty
/// network. Throws UsageError if sizes differ or an option is out of range, Cancelled.
TracedFeatures trace_features(std::span<const Vec3> points, const Features& features,
                              const TraceOptions& options, const Job& job = {});

}  // namespace spigolo
