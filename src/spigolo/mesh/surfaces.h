// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/surfaces.h - samples become triangles, as many surfaces as it takes
#pragma once

#include "spigolo/core/job.h"
#include "spigolo/mesh/mesher.h"
#include "spigolo/mesh/samples.h"
#include "spigolo/mesh/surface_points.h"

namespace spigolo {

/// One surface after the other, as long as samples are left out that could be one: a wall that ends
/// in another one cannot be part of a manifold, nor can two bodies that share a face. Appends to
/// the mesh and to its creases; a later surface gives way where it would run into an earlier one.
void find_surfaces(MeshSamples samples, const SurfacePoints& surface, SharpMesh& result,
                   const Job& job = {});

}  // namespace spigolo
