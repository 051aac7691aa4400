// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/quality.h - how well-shaped triangles are
#pragma once

#include "spigolo/core/triangle_mesh.h"

namespace spigolo {

/// Of the smallest angle of each triangle [rad], and of edges. All 0 without triangles.
struct TriangleQuality {
  double angle_mean = 0, angle_p5 = 0, angle_least = 0;  // an even triangle has pi / 3
  double slim = 0;                                       // share of triangles below 20 degrees
  double aspect_mean = 0;                    // longest edge over the height on it, 1.15 where even
  double edge_mean = 0, edge_deviation = 0;  // [unit] over all triangles' edges
};

TriangleQuality measure_quality(const TriangleMesh& mesh);

}  // namespace spigolo
