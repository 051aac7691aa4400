// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/measure/triangle_distance.h - the place of a triangle nearest to a point
#pragma once

#include <cstdint>

#include "spigolo/core/geometry.h"

namespace spigolo {

/// What of a triangle a nearest point lies on: its inside, edge i (from corner i to the next), or
/// corner i.
enum class TrianglePart : std::uint8_t { inside, edge0, edge1, edge2, corner0, corner1, corner2 };

struct TriangleFoot {
  Vec3 point;
  TrianglePart part = TrianglePart::inside;
};

/// The point of triangle a, b, c nearest to p. The triangle has area.
TriangleFoot nearest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace spigolo
