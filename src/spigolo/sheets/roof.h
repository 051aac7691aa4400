// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/roof.h - do two sheets end at their crossing, like the sides of a roof?
#pragma once

#include <array>
#include <optional>
#include <span>

#include "spigolo/sheets/cover.h"
#include "spigolo/sheets/crease.h"

namespace spigolo {

/// Looks at the neighbors of one point that lie on one of two crossing sheets, near the crossing.
class RoofTest {
 public:
  /// members: places of the neighborhood in `points`; least_deviation [rad] from flat.
  RoofTest(std::span<const Vec3> points, std::span<const std::uint32_t> members, double spacing,
           double least_deviation)
      : points_(points), members_(members), spacing_(spacing), least_deviation_(least_deviation) {}

  double least() const { return least_deviation_; }  // [rad]

  struct Roof {
    double deviation = 0;        // [rad] from flat
    std::array<Vec3, 2> into{};  // unit, square to the crease, into each sheet
  };

  /// The edge, or nothing if a sheet has too few points of its own, goes on beyond the crossing,
  /// stays away from it, or the angle is too small.
  std::optional<Roof> find(const Crease& crease, const PointSet& on_a, const PointSet& on_b) const;

 private:
  std::optional<Vec3> half_plane(const Crease& crease, const Vec3& normal,
                                 const PointSet& own) const;

  std::span<const Vec3> points_;
  std::span<const std::uint32_t> members_;
  double spacing_, least_deviation_;
};

}  // namespace spigolo
