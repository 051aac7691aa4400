// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/ply_reader.h - PLY: ascii and binary of both byte orders, any properties
#pragma once

#include "spigolo/core/triangle_mesh.h"
#include "spigolo/io/file_lines.h"
#include "spigolo/io/input_bytes.h"
#include "spigolo/io/read_report.h"

namespace spigolo {

/// Vertices with all their scalar properties as attributes, name and type kept (a repeated name
/// gets
/// "_2"); x, y, z of any type. List properties of vertices and elements other than vertex and face
/// are skipped and reported. with_faces: polygons (vertex_indices or vertex_index) become triangle
/// fans; without, they are counted only.
/// Throws InputError if the header or body is damaged, or the file shorter than the header claims;
/// nothing is allocated before the bytes are known to be there.
/// lines: receives the element 'edge' (vertex1, vertex2) if it is given.
TriangleMesh read_ply(const InputBytes& input, bool with_faces, ReadReport& report,
                      FileLines* lines = nullptr);

}  // namespace spigolo
