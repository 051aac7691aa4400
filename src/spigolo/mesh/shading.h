// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/shading.h - patches between creases, and normals that jump across creases only
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "spigolo/core/triangle_mesh.h"
#include "spigolo/mesh/check.h"

namespace spigolo {

/// Per triangle, the number of its patch: triangles joined by edges that are no creases, numbered
/// in the order of their first triangle.
std::vector<std::uint32_t> find_patches(const TriangleMesh& mesh,
                                        std::span<const VertexPair> creases);

/// Per triangle the unit normals of its corners: those of the triangles around the vertex, weighted
/// by their angle there, as far as one gets without crossing a crease.
std::vector<std::array<Vec3, 3>> corner_normals(const TriangleMesh& mesh,
                                                std::span<const VertexPair> creases);

}  // namespace spigolo
