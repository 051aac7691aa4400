// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/read_report.h - what a reader saw in a file beside the points
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "spigolo/core/geometry.h"

namespace spigolo {

/// Coordinates stored as integers: coordinate = integer * scale + offset, axis by axis.
struct CoordinateGrid {
  Vec3 scale{0.001, 0.001, 0.001};
  Vec3 offset;
};

struct ReadReport {
  std::string format;        // "ply", "text", "obj", "off", "stl", "pcd", "las"
  std::string version;       // as the file says it, e.g. "1.2, point format 3"; may be empty
  std::string encoding;      // "ascii", "binary_little_endian", "binary_compressed" ...
  std::uint64_t points = 0;  // as declared; where nothing is declared, as found
  std::uint64_t faces = 0;   // polygons in the file, read or not
  std::uint64_t lines = 0;   // polylines or edges in the file, read or not
  std::vector<std::string> skipped;    // elements, list properties, padding left aside, by name
  std::vector<std::string> warnings;   // one sentence each
  std::optional<CoordinateGrid> grid;  // of a LAS file; hand it to write_cloud to keep it
};

}  // namespace spigolo
