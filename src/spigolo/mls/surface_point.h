// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mls/surface_point.h - what a projection onto the surface gives, by any method
#pragma once

#include <array>
#include <cstdint>

#include "spigolo/core/geometry.h"

namespace spigolo {

/// What the projected point lies on, or why there is none. The numbers are those of `scalar_status`
/// in files.
enum class SurfaceStatus : std::uint8_t {
  sheet = 0,      // inside a smooth piece of the surface
  crease = 1,     // where two of them cross
  corner = 2,     // where three or more meet
  too_far = 3,    // no result: no sample within reach of the query
  too_few = 4,    // no result: fewer samples than the local fit needs
  degenerate = 5  // no result: the samples near the query lie on one line, or it is not finite
};

constexpr bool on_surface(SurfaceStatus status) { return status <= SurfaceStatus::corner; }

/// Where there is no result, `position` is the query and the rest is zero: never a NaN, unless the
/// query has one.
struct SurfacePoint {
  Vec3 position;
  Vec3 normal;                        // unit, sign arbitrary; on a crease that of one of its sheets
  std::array<double, 2> curvature{};  // [1 / unit of the points] principal, the larger one first;
                                      // positive where the surface bends towards the normal
  SurfaceStatus status = SurfaceStatus::degenerate;
};

/// A projection seen by someone who knows which side is outside.
struct OrientedFoot {
  Vec3 foot;            // nearest place of the surface, as the projection gives it
  Vec3 normal;          // unit, within a right angle of `up`
  double distance = 0;  // of the query along the normal; positive on the side of `up`
  bool found = false;   // else foot is the query and the rest is zero
};

/// up: any vector that points to the positive side there; needs no unit length.
inline OrientedFoot orient_foot(const SurfacePoint& s, const Vec3& query, const Vec3& up) {
  if (!on_surface(s.status)) return {query, {}, 0, false};
  const Vec3 normal = dot(s.normal, up) < 0 ? -s.normal : s.normal;
  const Vec3 off = query - s.position;
  return {s.position, normal, std::copysign(norm(off), dot(off, normal)), true};
}

}  // namespace spigolo
