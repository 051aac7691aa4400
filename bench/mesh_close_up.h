// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/mesh_close_up.h - one edge of meshes close up, side by side (after figures 63 to 65)
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "spigolo/core/triangle_mesh.h"
#include "spigolo/synth/synth.h"

namespace spigolo::bench {

using NamedMesh = std::pair<std::string, TriangleMesh>;

/// Meshes of one cloud, seen along the middle of the first crease of its shape, with the edges of
/// their triangles (in all colours only: they cost most of the bytes) and the true crease as a
/// line. Panels side by side in one file; panel_width [pixel], colors as of save_picture().
void draw_close_up(const std::vector<NamedMesh>& meshes, const SynthCloud& cloud,
                   const std::filesystem::path& file, int panel_width = 640, int colors = 0);

}  // namespace spigolo::bench
