// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/surface_points.h - a piecewise smooth surface as points with normals, and between
// them
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "spigolo/core/geometry.h"

namespace spigolo {

/// The surface at one place.
struct SurfaceFoot {
  Vec3 position;
  Vec3 normal;           // unit, sign arbitrary; zero: there is no surface here
  double curvature = 0;  // [1 / unit] the largest of a normal section
  double spacing = 0;    // [unit] of the cloud around here; 0: that of the whole cloud

  bool valid() const { return squared_norm(normal) > 0; }
};

/// Points of every sheet, in one canonical order.
struct SurfacePoints {
  std::vector<SurfaceFoot> points;
  std::vector<Vec3> tips;     // of cones: sharp, but on no crease
  std::vector<Vec3> loose;    // points of the cloud that no sheet was found for
  double spacing = 1;         // of the cloud they come from
  double disagreement = .15;  // [unit] sheets continued to one place that lie farther apart from
                              // their mean are not one surface

  /// The sheet of point `near` at a place up to two spacings from it; called by several threads.
  /// Empty: arcs from point to point.
  std::function<SurfaceFoot(std::uint32_t near, const Vec3& query)> continued;
};

}  // namespace spigolo
