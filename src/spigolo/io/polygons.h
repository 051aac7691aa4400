// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/polygons.h - polygons of a file become the triangles of a mesh
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "spigolo/core/triangle_mesh.h"
#include "spigolo/io/read_report.h"

namespace spigolo {

/// Largest vertex count a TriangleMesh can index.
inline constexpr std::uint64_t max_mesh_vertices = std::uint64_t{1} << 32;

/// Cuts polygons into fans. Triangles that name a vertex twice are left out and counted.
class PolygonFans {
 public:
  /// corners: indices of vertices that exist, any number of them.
  void add(std::span<const std::uint32_t> corners);
  /// Hands the triangles over; says in the report how many were left out.
  std::vector<std::array<std::uint32_t, 3>> take(ReadReport& report);

 private:
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::uint64_t degenerate_ = 0;
};

}  // namespace spigolo
