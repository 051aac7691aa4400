// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/pipeline/lines.cpp
#include "spigolo/pipeline/lines.h"

#include <utility>

#include "spigolo/core/stopwatch.h"

namespace spigolo {
namespace {

// [spacings] The thesis's methods mark samples, which lie beside the edge, not places on it.
constexpr double gauss_map_scatter = 0.3;

}  // namespace

Lines find_lines(std::span<const Vec3> points, const LinesOptions& options, const Job& job) {
  Lines lines;
  lines.detection = detect(points, options.detect, job);
  Stopwatch watch;
  TraceOptions trace;
  trace.spacing = lines.detection.spacing;
  trace.noise = lines.detection.noise;
  trace.scatter = options.detect.method == DetectMethod::sheets ? 0 : gauss_map_scatter;
  trace.tolerance = options.tolerance;
  TracedFeatures traced = trace_features(points, lines.detection.features, trace, job);
  lines.network = std::move(traced.network);
  lines.detection.features.curve = std::move(traced.curve_of_point);
  lines.tolerance = traced.tolerance;
  lines.seconds_trace = watch.lap();
  return lines;
}

}  // namespace spigolo
