// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/core/feature_curves.h - the network of feature lines: curves that end in shared corners
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "spigolo/core/geometry.h"

namespace spigolo {

inline constexpr std::int32_t no_corner = -1;

struct FeatureCorner {
  Vec3 position;
  std::int32_t valence = 0;  // curve ends that meet here
};

enum class CurveKind : std::uint8_t { edge = 0, border = 1 };

/// What a curve was recognised as; `spline` is everything that is neither straight nor round.
enum class CurveShape : std::uint8_t { spline = 0, line = 1, circle = 2, arc = 3 };

inline constexpr std::array<const char*, 4> curve_shape_names = {"spline", "line", "circle", "arc"};

/// A polynomial B-spline with clamped ends: poles.size() + degree + 1 knots that do not descend.
/// Empty where there is none.
struct CurveSpline {
  int degree = 3;
  std::vector<double> knots;
  std::vector<Vec3> poles;
};

/// A polyline from corner to corner. Its first and last point are the corners' positions to the
/// last bit, where it has corners.
struct FeatureCurve {
  CurveKind kind = CurveKind::edge;
  bool closed = false;  // the last point is joined to the first, which is not repeated
  std::array<std::int32_t, 2> corner = {no_corner, no_corner};  // at its first and last point
  std::vector<Vec3> points;                                     // at least two; three if closed
  std::vector<double> angle;  // [rad] deviation from flat at each point; 0 on borders
  std::int8_t convex = 0;     // 1 convex, -1 concave, 0 not known
  double residual = 0;        // rms distance of the samples it was found from, in input units
  double confidence = 1;      // 0 to 1
  bool bridged = false;       // some stretch was filled in between two strong ones
  CurveShape shape = CurveShape::spline;
  Vec3 center, axis;   // of circle and arc; axis unit, the points run counterclockwise about it
  double radius = 0;   // of circle and arc
  CurveSpline spline;  // through the points, of curves that are neither line nor round

  double length() const;
};

struct FeatureCurves {
  std::vector<FeatureCorner> corners;
  std::vector<FeatureCurve> curves;
};

/// Throws Error unless arrays match, points are finite, corners exist, ends lie on their corners
/// and each corner's valence is the number of ends that name it.
void validate(const FeatureCurves& network);

}  // namespace spigolo
