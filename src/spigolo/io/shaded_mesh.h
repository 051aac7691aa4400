// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/shaded_mesh.h - meshes that viewers show with sharp edges: OBJ with groups, GLB
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "spigolo/core/triangle_mesh.h"
#include "spigolo/io/atomic_file.h"
#include "spigolo/io/write_options.h"

namespace spigolo {

/// A mesh with what a viewer needs to draw creases sharp and all else smooth.
struct ShadedMesh {
  TriangleMesh mesh;
  std::vector<std::uint32_t> patch;                   // per triangle: patches end at creases
  std::vector<std::array<std::uint32_t, 2>> creases;  // mesh edges, as vertices
  std::vector<std::array<Vec3, 3>> corner_normals;  // per triangle; unit, one per side of a crease
};

/// OBJ with a smoothing group per patch and the creases as line elements; no attribute but colours.
void write_shaded_obj(AtomicFile& out, const ShadedMesh& shaded, WriteReport& report);

/// Binary glTF 2.0: vertices on creases are split, one for each side; the creases a second mesh of
/// lines. Positions are floats about the center of the mesh, which is the node's translation;
/// report.rounding says what was lost.
void write_glb(AtomicFile& out, const ShadedMesh& shaded, WriteReport& report);

/// Throws Error unless the arrays fit the mesh.
void validate(const ShadedMesh& shaded);

}  // namespace spigolo
