// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/separate.h - where a surface touches itself, it comes apart
#pragma once

#include <cstddef>
#include <vector>

#include "spigolo/core/triangle_mesh.h"
#include "spigolo/mesh/check.h"

namespace spigolo {

/// Makes an oriented mesh manifold without moving or losing a triangle. At edges with more than two
/// triangles those are paired that have the inside between them; then each fan of triangles at a
/// vertex gets a vertex of its own, at the same place; pairs that are joined at both ends get one
/// in the middle of the edge. Creases follow. Triangles at an edge that cannot be paired get a
/// border. Returns how many vertices were added.
std::size_t separate(TriangleMesh& mesh, std::vector<VertexPair>& creases);

}  // namespace spigolo
