// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/polygons.cpp
#include "spigolo/io/polygons.h"

#include <string>
#include <utility>

namespace spigolo {

void PolygonFans::add(std::span<const std::uint32_t> corners) {
  if (corners.size() < 3) ++degenerate_;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    const std::uint32_t a = corners[0], b = corners[i - 1], c = corners[i];
    if (a == b || b == c || c == a)
      ++degenerate_;
    else
      triangles_.push_back({a, b, c});
  }
}

std::vector<std::array<std::uint32_t, 3>> PolygonFans::take(ReadReport& report) {
  if (degenerate_ > 0)
    report.warnings.push_back(std::to_string(degenerate_) +
                              " triangles or polygons without area by their indices left out");
  return std::move(triangles_);
}

}  // namespace spigolo
