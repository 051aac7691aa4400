// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/core/triangle_mesh.h - triangles over a point cloud
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "spigolo/core/point_cloud.h"

namespace spigolo {

/// Lines as pairs of vertex indices, one a straight piece.
using Segments = std::vector<std::array<std::uint32_t, 2>>;

/// Vertices (with their attributes) and triangles as vertex indices, counterclockwise from outside.
struct TriangleMesh {
  PointCloud vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Throws Error unless the vertices are valid and every triangle names three different vertices
/// that exist.
void validate(const TriangleMesh& mesh);

}  // namespace spigolo
