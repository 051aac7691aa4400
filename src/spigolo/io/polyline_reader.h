// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/polyline_reader.h - the lines of PLY and OBJ files, for pictures and comparisons
#pragma once

#include <cstdint>
#include <vector>

#include "spigolo/core/geometry.h"
#include "spigolo/io/file_format.h"
#include "spigolo/io/input_bytes.h"

namespace spigolo {

/// Polylines over shared vertices, each of at least two.
struct Polylines {
  std::vector<Vec3> points;
  std::vector<std::vector<std::uint32_t>> lines;
};

/// `l` elements of OBJ; `edge` elements (vertex1, vertex2) of PLY, joined where one begins where
/// the last one ends and scalar_curve, if there is one, stays the same. Other formats have none.
/// Throws InputError as the readers of points do, and for a line that names a vertex that does not
/// exist.
Polylines read_polylines(const InputBytes& input, FileFormat format);

}  // namespace spigolo
