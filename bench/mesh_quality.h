// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/mesh_quality.h - how near a mesh is to the true surface and its edges
#pragma once

#include "spigolo/mesh/check.h"
#include "spigolo/synth/synth.h"

namespace spigolo::bench {

struct MeshQuality {
  double to_surface = 0, to_surface_most = 0;  // [spacings] rms and largest
  double from_surface = 0, from_surface_most = 0;
  double edge = 0, edge_most = 0;  // true edge to the mesh, mean and largest
  double bad_normals = 0;          // [%] of the mesh near edges, off by more than 5 degrees
  MeshCheck check;
};

MeshQuality judge(const TriangleMesh& mesh, const SynthCloud& s);

}  // namespace spigolo::bench
