// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/sheets/bend_test.cpp - a crease of little bend is found where it is
#include "spigolo/sheets/bend.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "spigolo/core/random.h"

namespace spigolo {
namespace {

constexpr double turn = 0.7;     // [rad] of the line against the axes
constexpr double crease_at = 1;  // from the center of the look
const Vec3 across{std::cos(turn), std::sin(turn), 0}, along{-across.y, across.x, 0};

// Points about the origin with heights above z = 0.
template <class Height>
SheetRegion look_at_height(const Height& height_at) {
  SheetRegion region;
  region.spacing = 1;
  region.smoothing = 3.5;
  Random random(3);
  while (region.points.size() < 400) {
    Vec3 p = random.in_ball() * 7;
    p.z = height_at(p);
    region.points.push_back(p);
  }
  return region;
}

Sheet one_sheet(const SheetRegion& region) {
  const std::vector<double> even(region.points.size(), 1);
  return fit_weighted_sheet(region.points, even, {}, {0, 0, 1}, 1, 1e-6);
}

TEST(Bend, FindsTheHalfPlanesBesideTheCenter) {
  const double slope = std::tan(radians(10));
  const SheetRegion region =
      look_at_height([&](const Vec3& p) { return slope * std::abs(dot(p, across) - crease_at); });
  const auto fold = fold_at_bend(region, one_sheet(region));
  ASSERT_TRUE(fold);
  ASSERT_EQ(fold->count, 2U);
  const auto crease = find_crease(fold->sheet[0], fold->sheet[1], {});
  ASSERT_TRUE(crease);
  EXPECT_NEAR(dot(crease->point, across), crease_at, 0.35);  // half a step between lines tried
  EXPECT_LT(axial_angle(crease->direction, along), radians(3));
  EXPECT_NEAR(degrees(axial_angle(crease->normal[0], crease->normal[1])), 20, 2);
}

TEST(Bend, NothingWhereTheSheetIsAPlane) {
  const SheetRegion region = look_at_height([](const Vec3& p) { return 0.1 * p.x; });
  Sheet plane = one_sheet(region);
  plane.a[3] = plane.a[4] = plane.a[5] = 0;
  EXPECT_FALSE(fold_at_bend(region, plane));
}

}  // namespace
}  // namespace spigolo
