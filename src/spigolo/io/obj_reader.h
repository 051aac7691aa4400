// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/obj_reader.h - Wavefront OBJ: vertices and polygons
#pragma once

#include "spigolo/core/triangle_mesh.h"
#include "spigolo/io/file_lines.h"
#include "spigolo/io/input_bytes.h"
#include "spigolo/io/read_report.h"

namespace spigolo {

/// `v x y z`, `v x y z w` (w is left aside) and `v x y z r g b` (colours become red, green, blue as
/// uint8, if every vertex has them). with_faces: polygons become triangle fans, whatever of
/// v/vt/vn, negative indices count back from the last vertex; without, they are counted only.
/// Lines are counted; all else is skipped.
/// Throws InputError with the number of the line for what cannot be read, and if there is no
/// vertex. A file cut between two lines cannot be told from a whole one.
/// lines: receives the 'l' polylines if it is given.
TriangleMesh read_obj(const InputBytes& input, bool with_faces, ReadReport& report,
                      FileLines* lines = nullptr);

}  // namespace spigolo
