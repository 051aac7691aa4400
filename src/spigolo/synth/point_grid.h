// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/point_grid.h - a growing set of points in hashed cells: is one near, how near
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "spigolo/core/geometry.h"

namespace spigolo {

class PointGrid {
 public:
  /// cell: side of a cell, > 0; twice the distance asked for is fastest. capacity: how many points
  /// are expected; more only cost time.
  PointGrid(double cell, std::size_t capacity);

  void insert(const Vec3& p);
  const std::vector<Vec3>& points() const { return points_; }

  /// Whether a point lies nearer to p than r.
  bool any_within(const Vec3& p, double r) const;

  /// Distance of point i to its nearest other point; infinite if there is none within 32 cells.
  double nearest_other(std::size_t i) const;

 private:
  struct Cell {
    std::int64_t x, y, z;
  };
  Cell cell_of(const Vec3& p) const;
  std::size_t bucket(const Cell& c) const;
  template <class Visit>
  void visit_ball(const Vec3& p, double r, const Visit& visit) const;

  double cell_;
  std::vector<std::uint32_t> head_;  // first point of a bucket, `none` if empty
  std::vector<std::uint32_t> next_;  // next point in the same bucket
  std::vector<Vec3> points_;
};

}  // namespace spigolo
