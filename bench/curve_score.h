// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/curve_score.h - a network of feature curves against the true edges of its shape
#pragma once

#include <span>
#include <vector>

#include "spigolo/core/feature_curves.h"
#include "spigolo/synth/shape.h"

namespace spigolo::bench {

/// Lengths in spacings.
struct CurveScore {
  std::size_t curves = 0, corners = 0, borders = 0;
  bool right = false;                 // as many curves and corners of each valence as the shape has
  double length = 0;                  // share of the true length
  double mean_off = 0, most_off = 0;  // curve to true edge
  double mean_true = 0, most_true = 0;  // true edge to curve, where one is within a spacing
  double covered = 0;                   // share of the true length within a spacing of a curve
  double corner_off = 0;                // worst corner; infinite where the shape has none
};

CurveScore score_curves(const FeatureCurves& network, const Shape& shape, double spacing);

/// Distance of each query to the nearest curve of that kind; infinite if there is none.
std::vector<double> distances_to_curves(const FeatureCurves& network, CurveKind kind,
                                        std::span<const Vec3> queries, double cell);

/// Places evenly along all curves of that kind.
std::vector<Vec3> places_along(const FeatureCurves& network, CurveKind kind, double step);

}  // namespace spigolo::bench
