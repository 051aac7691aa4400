// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mls/feature_line.h - the edge inside one neighborhood as a cubic Bezier curve (thesis
// §4.3.3)
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "spigolo/core/geometry.h"

namespace spigolo {

/// Control points b0 to b3; the parameter t runs from 0 to 1.
struct FeatureLine {
  std::array<Vec3, 4> b;
};

inline constexpr std::size_t feature_line_points = 4;  // with fewer feature points there is none

Vec3 point_at(const FeatureLine& line, double t);

/// b0 and b3 are the two feature points farthest apart (the first such pair), b1 and b2 the ones in
/// the middle of the two sectors into which the bisector plane of b0 and b3 parts the others; if
/// one sector is empty, the nearest of the other stands in. `features` is sorted by the distance to
/// b0. Nothing for fewer than four points or if all are at one place.
std::optional<FeatureLine> make_feature_line(std::vector<Vec3>& features);

/// Finds the nearest point of one line again and again: the nearest of nine places first,
/// then Newton's method refines.
class LineFoot {
 public:
  explicit LineFoot(const FeatureLine& line);
  Vec3 nearest(const Vec3& p) const;

 private:
  static constexpr std::size_t pieces = 8;

  std::array<Vec3, 4> power_;                // c0 + c1 t + c2 t^2 + c3 t^3
  std::array<Vec3, pieces + 1> at_piece_{};  // points of the curve
};

}  // namespace spigolo
