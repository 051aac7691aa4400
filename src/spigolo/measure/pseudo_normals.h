// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/measure/pseudo_normals.h - on which side of a mesh a point lies
#pragma once

#include <array>
#include <vector>

#include "spigolo/core/triangle_mesh.h"
#include "spigolo/measure/triangle_distance.h"

namespace spigolo {

/// Angle-weighted pseudo-normals (J. A. Baerentzen, H. Aanaes, Signed distance computation using
/// the angle weighted pseudonormal, 2005): seen from its nearest place on a closed mesh, a point
/// lies outside where the pseudo-normal of that place points to it. Vertices at the same place
/// count as one, so meshes without shared vertices work too.
class PseudoNormals {
 public:
  /// triangles: those of the mesh that have area.
  PseudoNormals(const std::vector<Vec3>& vertices,
                const std::vector<std::array<std::uint32_t, 3>>& triangles);

  /// Not normalized.
  const Vec3& at(std::size_t triangle, TrianglePart part) const;

 private:
  std::vector<std::array<Vec3, 7>> normals_;  // by TrianglePart
};

}  // namespace spigolo
