// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/mesh_writers.h - OBJ, OFF and STL
#pragma once

#include "spigolo/core/triangle_mesh.h"
#include "spigolo/io/atomic_file.h"
#include "spigolo/io/write_options.h"

namespace spigolo {

/// All three take the mesh as valid; a mesh without triangles is a cloud. The caller commits.
/// Of the attributes OBJ and OFF (then COFF) keep red, green, blue if they are uint8; the others
/// are dropped and reported. Doubles read back equal to the last bit.
void write_obj(AtomicFile& out, const TriangleMesh& mesh, WriteReport& report);
void write_off(AtomicFile& out, const TriangleMesh& mesh, WriteReport& report);

/// Binary STL keeps floats only: report.rounding says what was lost; ascii keeps doubles. Throws
/// UsageError if there is no triangle or, in binary, more than 2^32 - 1.
void write_stl(AtomicFile& out, const TriangleMesh& mesh, bool ascii, WriteReport& report);

}  // namespace spigolo
