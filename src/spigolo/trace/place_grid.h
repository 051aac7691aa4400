// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/place_grid.h - which of a few thousand places are near a query
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "spigolo/core/geometry.h"

namespace spigolo {

/// Places in cubic cells, sorted by cell; repeated places are allowed. Queries visit the cells in
/// one fixed order, and within a cell the places by index.
class PlaceGrid {
 public:
  /// cell: side of a cell, about the radius of the queries.
  PlaceGrid(std::span<const Vec3> places, double cell)
      : places_(places.begin(), places.end()), cell_(cell) {
    entries_.reserve(places.size());
    for (std::uint32_t i = 0; i < places_.size(); ++i)
      entries_.push_back(
          {key(cell_of(places_[i].x), cell_of(places_[i].y), cell_of(places_[i].z)), i});
    std::sort(entries_.begin(), entries_.end());
  }

  /// visit(index) for every place within r of p.
  template <class Visit>
  void within(const Vec3& p, double r, const Visit& visit) const {
    const std::int64_t z0 = cell_of(p.z - r), z1 = cell_of(p.z + r);
    for (std::int64_t x = cell_of(p.x - r); x <= cell_of(p.x + r); ++x)
      for (std::int64_t y = cell_of(p.y - r); y <= cell_of(p.y + r); ++y) {
        auto it = std::lower_bound(entries_.begin(), entries_.end(),
                                   std::pair(key(x, y, z0), std::uint32_t{0}));
        for (const std::uint64_t last = key(x, y, z1); it != entries_.end() && it->first <= last;
             ++it)
          if (squared_distance(places_[it->second], p) <= r * r) visit(it->second);
      }
  }

  /// The nearest place within r, the first of equals; no_place if there is none.
  std::uint32_t nearest(const Vec3& p, double r) const {
    std::uint32_t best = no_place;
    double least = infinity;
    within(p, r, [&](std::uint32_t i) {
      const double d = squared_distance(places_[i], p);
      if (d < least || (d == least && i < best)) least = d, best = i;
    });
    return best;
  }

  static constexpr std::uint32_t no_place = 0xffffffffu;

 private:
  static constexpr std::int64_t half_range = 1 << 20;

  std::int64_t cell_of(double x) const {
    const double c = std::floor(x / cell_);
    return static_cast<std::int64_t>(std::clamp(c, 1.0 - half_range, half_range - 1.0));
  }
  static std::uint64_t key(std::int64_t x, std::int64_t y, std::int64_t z) {
    const auto part = [](std::int64_t c) { return static_cast<std::uint64_t>(c + half_range); };
    return part(x) << 42 | part(y) << 21 | part(z);
  }

  std::vector<Vec3> places_;
  double cell_;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> entries_;
};

}  // namespace spigolo
