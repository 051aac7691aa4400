// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/off_reader.h - OFF: vertices and polygons
#pragma once

#include "spigolo/core/triangle_mesh.h"
#include "spigolo/io/input_bytes.h"
#include "spigolo/io/read_report.h"

namespace spigolo {

/// OFF, COFF (red green blue alpha become uint8), NOFF (nx ny nz) and CNOFF; the counts on the
/// first line or the next, the keyword may be missing; `#` comments. with_faces: polygons become
/// triangle fans; without, they are counted only. Throws InputError with the number of the line;
/// also for fewer rows than declared, and for the 4-dimensional, n-dimensional, texture and binary
/// variants.
TriangleMesh read_off(const InputBytes& input, bool with_faces, ReadReport& report);

}  // namespace spigolo
