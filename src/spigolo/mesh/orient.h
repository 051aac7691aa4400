// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/orient.h - one consistent outside per component, without normals
#pragma once

#include <cstddef>

#include "spigolo/core/job.h"
#include "spigolo/core/triangle_mesh.h"

namespace spigolo {

struct OrientReport {
  std::size_t turned = 0;          // triangles whose order of corners was reversed
  std::size_t not_orientable = 0;  // edges that no orientation can satisfy (Moebius strips)
};

/// Neighbors across edges with two triangles run along them in opposite directions; of each closed
/// piece the outside is outside (the walls of a cavity face the cavity), of an open piece what its
/// signed volume about its center calls so, and a flat one looks the way most of it did.
OrientReport orient_mesh(TriangleMesh& mesh, const Job& job = {});

}  // namespace spigolo
