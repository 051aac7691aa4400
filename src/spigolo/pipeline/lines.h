// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/pipeline/lines.h - from a raw cloud to feature curves and corners
#pragma once

#include <span>

#include "spigolo/core/feature_curves.h"
#include "spigolo/detect/detect.h"
#include "spigolo/trace/trace.h"

namespace spigolo {

struct LinesOptions {
  DetectOptions detect;
  double tolerance = automatic_tolerance;  // [input units] between splines and the curves they
                                           // stand for; > 0; automatic: from the noise
};

struct Lines {
  FeatureCurves network;
  Detection detection;   // features.curve names the curve of each feature point
  double tolerance = 0;  // [input units] used
  double seconds_trace = 0;
};

/// Detects features and traces them. No feature is an empty network, not an error. Throws what
/// detect() throws, and UsageError for a tolerance out of range.
Lines find_lines(std::span<const Vec3> points, const LinesOptions& options = {},
                 const Job& job = {});

}  // namespace spigolo
