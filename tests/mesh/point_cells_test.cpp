// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// mesh: points near a place, beside brute force
#include "spigolo/mesh/point_cells.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/clouds.h"

namespace spigolo {
namespace {

TEST(PointCells, findWhatBruteForceFindsForAnyRadius) {
  const std::vector<Vec3> points = test::random_sphere(3000, 5, 10);
  PointCells cells(1, points.size());
  for (const Vec3& p : points) cells.insert(p);
  for (const double r : {0.0, 0.3, 1.0, 4.0, 12.0, 1e6}) {
    for (const Vec3& p : {points[7], Vec3{0, 0, 9}, Vec3{20, 0, 0}}) {
      std::vector<std::uint32_t> found, expected;
      cells.any_within(p, r, [&](std::uint32_t i, double squared) {
        EXPECT_EQ(squared, squared_distance(points[i], p));
        found.push_back(i);
        return false;
      });
      for (std::uint32_t i = 0; i < points.size(); ++i)
        if (squared_distance(points[i], p) <= r * r) expected.push_back(i);
      std::sort(found.begin(), found.end());
      EXPECT_EQ(found, expected) << r;
      EXPECT_EQ(cells.any_within(p, r, [](std::uint32_t, double) { return true; }), !found.empty());
    }
  }
}

}  // namespace
}  // namespace spigolo
