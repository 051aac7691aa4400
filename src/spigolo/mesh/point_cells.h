// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/point_cells.h - points in hashed cells, for questions about what is near
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "spigolo/core/geometry.h"

namespace spigolo {

/// A growing list of points; cells of one side.
class PointCells {
 public:
  /// cell: side of a cell, > 0. expected: number of points; more only cost time.
  PointCells(double cell, std::size_t expected) : cell_(cell) {
    std::size_t buckets = 16;
    while (buckets < 2 * expected) buckets *= 2;
    head_.assign(buckets, none);
  }

  void insert(const Vec3& p) {
    const std::size_t b = bucket(coordinate(p.x), coordinate(p.y), coordinate(p.z));
    next_.push_back(head_[b]);
    head_[b] = static_cast<std::uint32_t>(points_.size());
    points_.push_back(p);
  }

  std::span<const Vec3> points() const { return points_; }

  /// Calls visit(i, squared distance) for the points within r of p, in an order that depends on the
  /// points alone, until it returns true; says whether it did. Takes no longer than all points do.
  template <class Visit>
  bool any_within(const Vec3& p, double r, const Visit& visit) const {
    const std::int64_t x0 = coordinate(p.x - r), x1 = coordinate(p.x + r);
    const std::int64_t y0 = coordinate(p.y - r), y1 = coordinate(p.y + r);
    const std::int64_t z0 = coordinate(p.z - r), z1 = coordinate(p.z + r);
    const auto count = [](std::int64_t a, std::int64_t b) {
      return static_cast<double>(b - a + 1);
    };
    const double cells = count(x0, x1) * count(y0, y1) * count(z0, z1);
    if (cells > many && cells > static_cast<double>(points_.size())) return any(p, r, visit);
    for (std::int64_t x = x0; x <= x1; ++x)
      for (std::int64_t y = y0; y <= y1; ++y)
        for (std::int64_t z = z0; z <= z1; ++z)
          for (std::uint32_t i = head_[bucket(x, y, z)]; i != none; i = next_[i]) {
            const Vec3& q = points_[i];
            // another cell may share the bucket
            if (coordinate(q.x) != x || coordinate(q.y) != y || coordinate(q.z) != z) continue;
            const double d = squared_distance(p, q);
            if (d <= r * r && visit(i, d)) return true;
          }
    return false;
  }

 private:
  static constexpr std::uint32_t none = 0xffffffffu;
  static constexpr double many = 4096;  // cells; fewer cost less than to look at their number

  template <class Visit>
  bool any(const Vec3& p, double r, const Visit& visit) const {
    for (std::uint32_t i = 0; i < points_.size(); ++i)
      if (const double d = squared_distance(p, points_[i]); d <= r * r && visit(i, d)) return true;
    return false;
  }

  std::int64_t coordinate(double x) const {
    return static_cast<std::int64_t>(std::floor(x / cell_));
  }
  std::size_t bucket(std::int64_t x, std::int64_t y, std::int64_t z) const {
    const std::uint64_t h = static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15 ^
                            static_cast<std::uint64_t>(y) * 0xc2b2ae3d27d4eb4f ^
                            static_cast<std::uint64_t>(z) * 0x165667b19e3779f9;
    return (h ^ h >> 29) & (head_.size() - 1);
  }

  double cell_;
  std::vector<std::uint32_t> head_, next_;
  std::vector<Vec3> points_;
};

}  // namespace spigolo
