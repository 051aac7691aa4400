// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// trace/rims: circles of a few spacings, from marks that see them inexactly
#include "spigolo/trace/rims.h"

#include <gtest/gtest.h>

#include <cmath>

namespace spigolo::test {
namespace {

constexpr double radius = 2.1;

Vec3 round(double turn, double r, double z) {
  return {r * std::cos(2 * pi * turn), r * std::sin(2 * pi * turn), z};
}

// A wall from one height to another, and a plane with a hole at z = 0 if there is one.
std::vector<Vec3> drilled(double from, double to, bool plane) {
  std::vector<Vec3> points;
  for (double z = from; z <= to; z += 0.8)
    for (double k = 0; k < 14; ++k) points.push_back(round((k + 0.3 * z) / 14, radius, z));
  for (double x = -9.2; plane && x < 9.3; ++x)
    for (double y = -9.4; y < 9.3; ++y)
      if (std::hypot(x, y) > radius) points.push_back({x, y, 0});
  return points;
}

std::vector<CreaseSample> marks_round(std::size_t count, double z) {
  std::vector<CreaseSample> marks;
  for (std::size_t k = 0; k < count; ++k) {
    const double turn = static_cast<double>(k) / static_cast<double>(count);
    CreaseSample mark;
    mark.place = round(turn, radius + (k % 2 == 0 ? 0.3 : -0.25), z);
    mark.direction = {-std::sin(2 * pi * turn), std::cos(2 * pi * turn), 0};
    mark.angle = half_pi;
    marks.push_back(mark);
  }
  return marks;
}

std::vector<CurveDraft> rims(const std::vector<Vec3>& points,
                             const std::vector<CreaseSample>& marks) {
  const Survey survey(points, CreaseSamples{}, 0, {});
  return find_rims(marks, survey, {});
}

TEST(Rims, theWallOfAHoleSaysWhereItsRimIs) {
  const auto found = rims(drilled(-4, -0.1, true), marks_round(8, 0));
  ASSERT_EQ(found.size(), 1u);
  const auto& circle = std::get<CircleFit>(found[0].form);
  EXPECT_NEAR(circle.radius, radius, 1e-6);
  EXPECT_NEAR(norm(circle.center), 0, 1e-6);
  EXPECT_NEAR(std::abs(circle.axis.z), 1, 1e-9);
  EXPECT_TRUE(found[0].guide.closed);
  EXPECT_EQ(found[0].members.size(), 8u);
}

TEST(Rims, aWallThatGoesOnToBothSidesHasNone) {
  EXPECT_TRUE(rims(drilled(-4, 4, false), marks_round(8, 0)).empty());
}

TEST(Rims, fewMarksWithoutAWallAreNone) {
  EXPECT_TRUE(rims(drilled(0, -1, true), marks_round(6, 0)).empty());
}

TEST(Rims, marksOffOnePlaneAreNone) {
  std::vector<CreaseSample> marks = marks_round(8, 0);
  for (std::size_t k = 0; k < marks.size(); ++k)
    marks[k].place.z = 0.3 * static_cast<double>(k * k % 5);
  EXPECT_TRUE(rims(drilled(-4, -0.1, true), marks).empty());
}

}  // namespace
}  // namespace spigolo::test
