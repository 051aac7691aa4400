// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/trace/support.h - networks of constructed shapes, and how far off they are
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "spigolo/core/feature_curves.h"
#include "spigolo/detect/detect.h"
#include "spigolo/synth/synth.h"
#include "spigolo/trace/trace.h"

namespace spigolo::test {

struct Traced {
  SynthCloud synth;
  Detection detection;
  TracedFeatures traced;

  const FeatureCurves& network() const { return traced.network; }
};

inline TracedFeatures trace_cloud(std::span<const Vec3> points, Detection* seen = nullptr) {
  const Detection detection = detect(points);
  TraceOptions options;
  options.spacing = detection.spacing;
  options.noise = detection.noise;
  TracedFeatures traced = trace_features(points, detection.features, options);
  validate(traced.network);
  if (seen) *seen = detection;
  return traced;
}

inline Traced trace_shape(const std::string& shape, Sampling sampling, std::size_t points = 0,
                          double noise = 0) {
  SynthOptions options;
  options.shape = shape;
  options.sampling = sampling;
  options.points = points;
  options.noise = noise;
  options.seed = 7;
  Traced result{make_cloud(options), {}, {}};
  result.traced = trace_cloud(result.synth.cloud.points, &result.detection);
  return result;
}

inline std::vector<FeatureCurve> curves_of_kind(const FeatureCurves& network, CurveKind kind) {
  std::vector<FeatureCurve> curves;
  for (const FeatureCurve& curve : network.curves)
    if (curve.kind == kind) curves.push_back(curve);
  return curves;
}

inline std::size_t count_shape(const FeatureCurves& network, CurveShape shape) {
  return static_cast<std::size_t>(std::count_if(
      network.curves.begin(), network.curves.end(),
      [&](const FeatureCurve& c) { return c.kind == CurveKind::edge && c.shape == shape; }));
}

inline double total_length(const FeatureCurves& network) {
  double sum = 0;
  for (const FeatureCurve& curve : network.curves)
    if (curve.kind == CurveKind::edge) sum += curve.length();
  return sum;
}

inline double length_of(const Curve& curve) {
  double sum = 0;
  constexpr int steps = 4000;
  for (int i = 0; i < steps; ++i)
    sum += distance(curve.at(static_cast<double>(i) / steps),
                    curve.at(static_cast<double>(i + 1) / steps));
  return sum;
}

inline double true_length(const Shape& shape) {
  double sum = 0;
  for (const ExactCrease& crease : shape.creases) sum += length_of(crease.curve);
  return sum;
}

/// Largest distance of a point of the network's edges to the true creases.
inline double farthest_off(const FeatureCurves& network, const Shape& shape) {
  double most = 0;
  for (const FeatureCurve& curve : network.curves)
    for (const Vec3& p : curve.points)
      if (curve.kind == CurveKind::edge) most = std::max(most, edge_distance(shape, p));
  return most;
}

}  // namespace spigolo::test
