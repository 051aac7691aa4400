// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/write_options.h - how a file is written, and what did not fit into it
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "spigolo/io/read_report.h"

namespace spigolo {

struct WriteOptions {
  bool ascii = false;                  // ply, pcd, stl: text instead of binary
  bool compressed = false;             // pcd: binary_compressed
  std::optional<CoordinateGrid> grid;  // las: use it if the coordinates fit; else one is chosen
  std::vector<std::string> comments;   // ply: lines of the header
};

struct WriteReport {
  double rounding = 0;               // largest change of a coordinate by the format
  std::vector<std::string> dropped;  // attributes the format has no place for
};

}  // namespace spigolo
