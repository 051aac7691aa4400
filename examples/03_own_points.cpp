// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// examples/03_own_points.cpp - points that are in memory already, and the angle of their edge
#include <spigolo/spigolo.h>

#include <cstdio>
#include <span>
#include <vector>

namespace {

// Two roof planes that meet in a ridge along y; rise: height of the ridge over a run of 1.
std::vector<spigolo::Vec3> roof(double rise) {
  std::vector<spigolo::Vec3> points;
  for (int i = -20; i <= 20; ++i)
    for (int j = 0; j <= 40; ++j) points.push_back({1.0 * i, 1.0 * j, -rise * (i < 0 ? -i : i)});
  return points;
}

}  // namespace

int main() {
  const std::vector<spigolo::Vec3> points = roof(1.0);
  spigolo::DetectOptions options;
  options.sensitivity = 0.7;  // more obtuse edges; the other options keep their defaults

  // Any contiguous array of Vec3 will do; nothing is copied into another type first.
  const spigolo::Detection found = spigolo::detect(std::span(points), options);

  // Features are arrays with one entry per point, in the order of the points.
  const spigolo::Features& f = found.features;
  std::size_t ridge = 0;
  double sum = 0;
  for (std::size_t i = 0; i < f.size(); ++i) {
    if (f.kind[i] != spigolo::PointKind::edge) continue;
    ++ridge;
    sum += spigolo::degrees(f.angle[i]);  // deviation from flat; the sheets meet at 180 minus it
  }
  if (ridge == 0) return 1;
  const double deviation = sum / static_cast<double>(ridge);
  std::printf("%zu of %zu points lie on the ridge; its sheets meet at %.1f degrees\n", ridge,
              points.size(), 180 - deviation);
  return 0;
}
