// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/heat_map.h - a table of shares as a picture
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace spigolo::bench {

/// One panel: value[row][column] in 0..1, a colour and two digits for each.
struct HeatMap {
  std::string title, across, down;  // of the panel, of the columns, of the rows
  std::vector<std::string> columns, rows;
  std::vector<std::vector<double>> value;
};

/// Panels side by side; the folder is made if need be.
void write_heat_maps(const std::filesystem::path& png, const std::vector<HeatMap>& panels);

}  // namespace spigolo::bench
