// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/line_chart.h - a few curves over one axis as a picture
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace spigolo::bench {

/// One panel: curves[i].second[j] is the value of the curve named curves[i].first at x[j].
struct LineChart {
  std::string title, across, up;
  std::vector<double> x;  // ascending
  std::vector<std::pair<std::string, std::vector<double>>> curves;
  double low = 0, high = 1;   // of the upright axis; what lies outside is drawn at its end
  bool decades = false;       // the upright axis is logarithmic
  bool x_decades = false;     // the other one is
  bool legend_below = false;  // at the lower left, not the upper right
};

/// Panels side by side; the folder is made if need be.
void write_line_charts(const std::filesystem::path& png, const std::vector<LineChart>& panels);

}  // namespace spigolo::bench
