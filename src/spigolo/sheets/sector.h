// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/sector.h - directions around a point in which a sheet has no other point
#pragma once

#include <span>

#include "spigolo/sheets/cover.h"

namespace spigolo {

/// Of directions in the plane of a sheet's frame, measured from u towards v.
struct Sector {
  double from = 0, width = 2 * pi;  // [rad]

  /// How far inside its nearer side a direction lies [rad]; negative outside.
  double inside(double direction) const;
};

/// The widest sector around members[0] without any of the other members that are `on`.
Sector widest_sector(std::span<const Vec3> points, std::span<const std::uint32_t> members,
                     const Sheet& sheet, const PointSet& on);

}  // namespace spigolo
