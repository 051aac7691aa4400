// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/core/features.h - the verdict on every point of a cloud
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "spigolo/core/geometry.h"

namespace spigolo {

/// What a point lies on. The numbers are those of `scalar_kind` in files.
enum class PointKind : std::uint8_t { surface = 0, edge = 1, corner = 2, tip = 3, border = 4 };

inline constexpr std::size_t point_kinds = 5;
inline constexpr std::array<const char*, point_kinds> point_kind_names = {
    "surface", "edge", "corner", "tip", "border"};

/// One entry per input point, in input order.
struct Features {
  std::vector<PointKind> kind;
  std::vector<double> angle;    // [rad] deviation from flat in [0, pi]; 0 for surface and border
  std::vector<float> strength;  // in [0, 1]; 0 for surface
  std::vector<std::int8_t> convex;   // 1 convex, -1 concave, 0 not known or not on an edge
  std::vector<std::int32_t> curve;   // feature curve it belongs to, -1 if none
  std::vector<Vec3> crease_point;    // nearest point on the crease; NaN for surface
  std::vector<Vec3> direction;       // unit, along the crease (sign arbitrary); zero if not known
  std::vector<std::uint8_t> sheets;  // smooth sheets that meet: 1 surface and border, 2 edge, 3 ...

  std::size_t size() const { return kind.size(); }
  /// Makes n points of smooth surface.
  void assign_surface(std::size_t n);
  /// How many points of each kind.
  std::array<std::size_t, point_kinds> counts() const;
};

/// Throws Error unless all arrays have one entry per point and each is in its range.
void validate(const Features& features);

}  // namespace spigolo
