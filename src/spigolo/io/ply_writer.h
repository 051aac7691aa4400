// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/ply_writer.h - PLY, binary little-endian or ascii
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "spigolo/core/triangle_mesh.h"
#include "spigolo/io/atomic_file.h"

namespace spigolo {

/// A further element of scalars, such as `edge` with vertex1 and vertex2.
struct PlyElement {
  std::string name;
  std::vector<Attribute> columns;  // of one length
};

struct PlyOptions {
  bool ascii = false;
  std::vector<std::string> comments;  // lines of the header
};

/// Writes x y z as double, then the attributes in order and type; then the faces, if any; then the
/// further elements. The caller commits the file.
void write_ply(AtomicFile& out, const PointCloud& vertices,
               std::span<const std::array<std::uint32_t, 3>> triangles = {},
               std::span<const PlyElement> more = {}, const PlyOptions& options = {});

}  // namespace spigolo
