// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/sector.cpp
#include "spigolo/sheets/sector.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace spigolo {

double Sector::inside(double direction) const {
  const double turned = direction - from;
  const double angle = turned - 2 * pi * std::floor(turned / (2 * pi));  // 0 to 2 pi
  if (angle <= width) return std::min(angle, width - angle);
  return -std::min(angle - width, 2 * pi - angle);
}

Sector widest_sector(std::span<const Vec3> points, std::span<const std::uint32_t> members,
                     const Sheet& sheet, const PointSet& on) {
  std::array<double, max_cover_points> angles;
  std::size_t n = 0;
  for (std::size_t m = 1; m < members.size(); ++m) {
    if (!on[m]) continue;
    const Vec3 d = points[members[m]] - points[members[0]];
    angles[n++] = std::atan2(dot(d, sheet.v), dot(d, sheet.u));
  }
  if (n == 0) return {};
  std::sort(angles.begin(), angles.begin() + static_cast<std::ptrdiff_t>(n));
  Sector widest{angles[n - 1], angles[0] + 2 * pi - angles[n - 1]};
  for (std::size_t i = 1; i < n; ++i)
    if (const double width = angles[i] - angles[i - 1]; width > widest.width)
      widest = {angles[i - 1], width};
  return widest;
}

}  // namespace spigolo
