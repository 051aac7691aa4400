// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/roof.cpp
#include "spigolo/sheets/roof.h"

#include <algorithm>
#include <cmath>

namespace spigolo {
namespace {

// All in spacings, measured from the crossing.
constexpr double along_window = 1.5;   // a sheet may go on elsewhere: only what lies beside counts
constexpr double across_window = 1.5;  // a sheet that ends here may begin again behind a slot
constexpr double beyond = 0.5;         // behind the crossing, with room for an error of position
constexpr double in_front = 0.3;
constexpr double beyond_share = 0.25;  // of those in front, plus half a point
constexpr double least_extent = 0.8;   // a sheet reaches so far from the crossing
constexpr double widest_gap = 1.6;     // and comes so close to it
constexpr int least_points = 3;

}  // namespace

// Unit vector in the sheet, from the crossing to the sheet's points; nothing if it does not end
// here.
std::optional<Vec3> RoofTest::half_plane(const Crease& crease, const Vec3& normal,
                                         const PointSet& own) const {
  const Vec3 side = cross(normal, crease.direction);
  std::array<double, max_cover_points> across, along;
  std::size_t n = 0;
  double sum = 0;
  for (std::size_t m = 0; m < members_.size(); ++m) {
    if (!own[m]) continue;
    const Vec3 d = (points_[members_[m]] - crease.point) / spacing_;
    across[n] = dot(d, side);
    along[n] = std::abs(dot(d, crease.direction));
    sum += std::clamp(across[n++], -across_window, across_window);
  }
  if (n < least_points) return std::nullopt;
  const double sign = sum < 0 ? -1 : 1;
  int behind = 0, front = 0;
  double farthest = 0, closest = infinity;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = sign * across[i];
    const bool beside = along[i] < along_window;
    behind += beside && x < -beyond && x > -across_window;
    front += beside && x > in_front && x < across_window;
    farthest = std::max(farthest, x);
    closest = std::min(closest, std::abs(x));
  }
  if (behind > beyond_share * front + 0.5 || farthest < least_extent || closest > widest_gap)
    return std::nullopt;
  return side * sign;
}

std::optional<RoofTest::Roof> RoofTest::find(const Crease& crease, const PointSet& on_a,
                                             const PointSet& on_b) const {
  const auto a = half_plane(crease, crease.normal[0], on_a & ~on_b);
  if (!a) return std::nullopt;
  const auto b = half_plane(crease, crease.normal[1], on_b & ~on_a);
  if (!b) return std::nullopt;
  const double deviation = pi - angle_between(*a, *b);
  if (deviation < least_deviation_) return std::nullopt;
  return Roof{deviation, {*a, *b}};
}

}  // namespace spigolo
