// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/verdict_rows.h - a verdict for every point, of which most say nothing
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "spigolo/core/features.h"
#include "spigolo/index/order.h"

namespace spigolo {

struct SheetVerdict {
  PointKind kind = PointKind::surface;
  double deviation = 0;  // [rad] angle from flat, 0 for surface and border
  double strength = 0;   // 0 to 1: how likely it is right, see rate_verdicts
  Vec3 crease_point;     // nearest point on the crease, corner or (of a border) the point itself
  Vec3 direction;        // unit, along the crease; zero unless an edge
  std::array<Vec3, 2> into{};  // of an edge: unit, square to it, from the crease into each sheet
  std::uint8_t sheets = 1;     // that meet: 2 at an edge, 3 or more at a corner
  std::int8_t folded = 0;      // by a fold test (HingeTest): 1 sharp, -1 rounded, 0 not known
  std::int8_t convex = 0;      // 1 convex, -1 concave, 0 not known or no edge

  bool says_nothing() const { return kind == PointKind::surface && folded == 0; }
};

/// A point and its verdict.
using FoundVerdict = std::pair<std::uint32_t, SheetVerdict>;

/// As if an array of verdicts; four bytes for a point that has none. Changed by one thread only.
class VerdictRows {
 public:
  explicit VerdictRows(std::size_t n = 0) : row_(n, no_point) {}
  VerdictRows(std::size_t n, std::span<const FoundVerdict> found) : VerdictRows(n) {
    rows_.reserve(found.size());
    set(found);
  }

  std::size_t size() const { return row_.size(); }

  /// Valid until the next change. Surface where nothing is said.
  const SheetVerdict& operator[](std::size_t i) const {
    static constexpr SheetVerdict nothing;
    return row_[i] == no_point ? nothing : rows_[row_[i]];
  }

  /// To be changed in place. Valid until the next change of another one.
  SheetVerdict& edit(std::size_t i) {
    if (row_[i] == no_point) {
      row_[i] = static_cast<std::uint32_t>(rows_.size());
      rows_.emplace_back();
    }
    return rows_[row_[i]];
  }

  void set(std::size_t i, const SheetVerdict& verdict) {
    if (!verdict.says_nothing())
      edit(i) = verdict;
    else
      row_[i] = no_point;
  }
  void set(std::span<const FoundVerdict> found) {
    for (const auto& [i, verdict] : found) set(i, verdict);
  }

 private:
  std::vector<std::uint32_t> row_;
  std::vector<SheetVerdict> rows_;
};

}  // namespace spigolo
