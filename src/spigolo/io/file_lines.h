// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/file_lines.h - the lines of PLY and OBJ files, for pictures and comparisons
#pragma once

#include <cstdint>
#include <vector>

#include "spigolo/core/triangle_mesh.h"

namespace spigolo {

/// Each a chain of at least two vertices of the file: an `l` of OBJ; elements `edge` (vertex1,
/// vertex2) of PLY, joined where one begins where the last one ends and scalar_curve, if there is
/// one, stays the same.
using FileLines = std::vector<std::vector<std::uint32_t>>;

/// Their straight pieces, in order.
inline Segments pieces_of(const FileLines& lines) {
  Segments pieces;
  for (const auto& line : lines)
    for (std::size_t i = 1; i < line.size(); ++i) pieces.push_back({line[i - 1], line[i]});
  return pieces;
}

}  // namespace spigolo
