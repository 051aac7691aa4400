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
