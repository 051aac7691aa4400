// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/stl_reader.h - STL: ascii and binary, equal vertices welded
#pragma once

#include "spigolo/core/triangle_mesh.h"
#include "spigolo/io/input_bytes.h"
#include "spigolo/io/read_report.h"

namespace spigolo {

/// Vertices in the order of their first appearance, those of equal coordinates made one. Which of
/// the two encodings it is follows from the size: some binary files begin with "solid" too. Normals
/// and attribute bytes are left aside. with_faces: without it only the vertices are returned.
/// Throws InputError with byte or line if the file is cut off, damaged or neither encoding.
TriangleMesh read_stl(const InputBytes& input, bool with_faces, ReadReport& report);

}  // namespace spigolo
