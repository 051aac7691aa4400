// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/core/features.cpp
#include "spigolo/core/features.h"

#include <string>

#include "spigolo/core/error.h"

namespace spigolo {

void Features::assign_surface(std::size_t n) {
  kind.assign(n, PointKind::surface);
  angle.assign(n, 0.0);
  strength.assign(n, 0.0f);
  convex.assign(n, std::int8_t{0});
  curve.assign(n, -1);
  crease_point.assign(n, Vec3{not_a_number, not_a_number, not_a_number});
  direction.assign(n, Vec3{});
  sheets.assign(n, std::uint8_t{1});
}

std::array<std::size_t, point_kinds> Features::counts() const {
  std::array<std::size_t, point_kinds> counts{};
  for (const PointKind k : kind) ++counts[static_cast<std::size_t>(k)];
  return counts;
}

void validate(const Features& f) {
  const std::size_t n = f.size();
  if (f.angle.size() != n || f.strength.size() != n || f.convex.size() != n ||
      f.curve.size() != n || f.crease_point.size() != n || f.direction.size() != n ||
      f.sheets.size() != n)
    throw Error("features: the arrays differ in length");
  for (std::size_t i = 0; i < n; ++i) {
    const bool smooth = f.kind[i] == PointKind::surface;
    const bool flat = smooth || f.kind[i] == PointKind::border;
    const bool sound = static_cast<std::size_t>(f.kind[i]) < point_kinds && f.angle[i] >= 0 &&
                       f.angle[i] <= pi && (!flat || f.angle[i] == 0) && f.strength[i] >= 0 &&
                       f.strength[i] <= 1 && (!smooth || f.strength[i] == 0) && f.convex[i] >= -1 &&
                       f.convex[i] <= 1 && f.curve[i] >= -1 &&
                       is_finite(f.crease_point[i]) == !smooth;
    if (!sound) throw Error("features: the entry of point " + std::to_string(i) + " is not sound");
  }
}

}  // namespace spigolo
