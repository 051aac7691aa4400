// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/curve_distance.h - nearest place on the intersection curve
#pragma once

#include <span>
#include <vector>

#include "spigolo/index/kd_tree.h"

namespace spigolo {

struct CurvePlace {
  double distance = infinity;
  std::size_t index =
      0;             // the place lies between points index and index + 1 (closed: or the first)
  double share = 0;  // in [0, 1] of the way between them
};

/// A polyline, closed or not, of at least two points.
class CurveDistance {
 public:
  CurveDistance(std::span<const Vec3> points, bool closed);

  /// Exact for the segments at the nearest of the points, which is the nearest place unless the
  /// curve bends sharply within one segment.
  CurvePlace nearest(const Vec3& p, std::vector<Neighbor>& scratch) const;

  double length() const { return length_; }

  /// A value given at each point, at a place between.
  double interpolate(std::span<const double> values, const CurvePlace& place) const;

 private:
  void try_segment(std::size_t i, const Vec3& p, CurvePlace& best) const;

  std::vector<Vec3> points_;
  bool closed_;
  double length_ = 0;
  OrderedCloud ordered_;
  std::vector<std::uint32_t> point_of_;  // canonical place -> number of the point
  KdTree tree_;
};

}  // namespace spigolo
