// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/curve_tables.h - a network of curves as tables, for its writers
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "spigolo/core/feature_curves.h"

namespace spigolo {

/// All vertices of a network, corners first and once each, and each curve as a row of vertices; a
/// closed one repeats its first vertex at the end.
struct CurveVertices {
  std::vector<Vec3> points;
  std::vector<double> angle;  // [rad] of each vertex; of corners that of a curve that ends there
  std::vector<std::vector<std::uint32_t>> curve;
};
CurveVertices shared_vertices(const FeatureCurves& network);

struct AngleRange {
  double min = 0, mean = 0, max = 0;  // [rad]
};
AngleRange angle_range(const FeatureCurve& curve);

/// "edge" or "border".
const char* kind_name(CurveKind kind);

/// The curve as a rational B-spline that it is exactly: degree 1 for lines (and polylines without a
/// spline), 2 for circles and arcs, 3 for splines. One weight a pole.
struct RationalSpline {
  int degree = 1;
  std::vector<double> knots;
  std::vector<Vec3> poles;
  std::vector<double> weights;
};
RationalSpline rational_spline(const FeatureCurve& curve);

/// [rad] swept by an arc from its first to its last point; 2 pi for a circle.
double sweep_of(const FeatureCurve& curve);

/// Appends the shortest text that reads back to the same double.
void append_double(std::string& out, double value);

}  // namespace spigolo
