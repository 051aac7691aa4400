// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
#include "spigolo/sheets/sheet.h"

#include <gtest/gtest.h>

#include "spigolo/core/random.h"
#include "spigolo/sheets/crease.h"
#include "spigolo/sheets/own_sheet.h"

namespace spigolo {
namespace {

// Points of z = c + a x + b y + d xx + e xy + f yy, moved and turned out of the axes.
struct Placed {
  Vec3 x, y, z, origin;
  Vec3 operator()(const Vec3& p) const { return origin + x * p.x + y * p.y + z * p.z; }
};

Placed random_frame(Random& random) {
  Placed f;
  f.z = random.on_sphere();
  f.x = any_perpendicular(f.z);
  f.y = cross(f.z, f.x);
  f.origin = random.in_ball() * 100.0;
  return f;
}

std::vector<Vec3> patch(const Placed& frame, double curvature, int count, Random& random) {
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) {
    const double x = random.uniform(-2, 2), y = random.uniform(-2, 2);
    points.push_back(frame({x, y, curvature * (x * x - 0.5 * y * y + 0.3 * x * y)}));
  }
  return points;
}

TEST(Sheet, ARidgeIsTheSameInEveryFrame) {
  Random random(73);
  for (int trial = 0; trial < 20; ++trial) {
    const Placed frame = random_frame(random);
    std::vector<Vec3> points = patch(frame, 0.1, 40, random), turned;
    const double angle = random.uniform(0, 2 * pi);  // about the normal that the fit is told
    const auto turn = [&](const Vec3& p) {
      const Vec3 d = p - frame.origin;
      const double u = dot(d, frame.x), v = dot(d, frame.y);
      return frame({u * std::cos(angle) - v * std::sin(angle),
                    u * std::sin(angle) + v * std::cos(angle), dot(d, frame.z)});
    };
    for (const Vec3& p : points) turned.push_back(turn(p));
    const std::vector<double> weights(points.size(), 1);
    const auto fit = [&](const std::vector<Vec3>& to) {
      return fit_weighted_sheet(to, weights, frame.origin, frame.z, 1, 0.1);
    };
    const Vec3 place = frame({0.4, -0.7, 0.2});
    EXPECT_NEAR(height(fit(points), place), height(fit(turned), turn(place)), 1e-9);
  }
}

TEST(Sheet, PlanesAreFittedExactly) {
  Random random(71);
  for (int trial = 0; trial < 50; ++trial) {
    const Placed frame = random_frame(random);
    const auto points = patch(frame, 0, 12, random);
    for (const SheetOrder order : {SheetOrder::plane, SheetOrder::quadric}) {
      const Sheet sheet = fit_sheet(points, {}, 1, order);
      EXPECT_EQ(sheet.support, 12);
      EXPECT_LT(sheet.deviation, 1e-9);
      EXPECT_LT(axial_angle(normal_at(sheet, points[3]), frame.z), 1e-8);
      EXPECT_NEAR(std::abs(height(sheet, frame({0.5, -0.5, 1.25}))), 1.25, 1e-8);
    }
  }
}

TEST(Sheet, QuadricsAreFittedWhereTheirHeightIsTheModel) {
  Random random(72);
  const Placed frame = random_frame(random);
  const auto points = patch(frame, 0.05, 24, random);
  const Sheet plane = fit_sheet(points, {}, 1, SheetOrder::plane);
  const Sheet quadric = fit_sheet(points, {}, 1, SheetOrder::quadric);
  EXPECT_GT(plane.deviation, 0.03);
  EXPECT_LT(quadric.deviation, 0.002);  // not zero: the frame leans a little, which is third order
}

TEST(Sheet, MaskLeavesPointsOut) {
  Random random(73);
  auto points = patch(random_frame(random), 0, 12, random);
  std::vector<char> use(13, 1);
  points.push_back({50, 60, 70});
  use[12] = 0;
  EXPECT_LT(fit_sheet(points, use, 1, SheetOrder::quadric).deviation, 1e-9);
}

TEST(Sheet, TooFewPointsAreNoSheet) {
  const std::vector<Vec3> two = {{0, 0, 0}, {1, 0, 0}};
  EXPECT_FALSE(fit_sheet(two, {}, 1, SheetOrder::plane).fitted());
  const std::vector<Vec3> three = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  EXPECT_TRUE(fit_sheet(three, {}, 1, SheetOrder::quadric).fitted());
}

// A sphere and a plane through it: their crossing is a circle of known radius and height.
TEST(Crease, OfASphereAndAPlaneIsTheirCircle) {
  Random random(74);
  std::vector<Vec3> cap = {{6, 0, 8}}, plane = {{6, 0, 8}};
  for (int i = 0; i < 40; ++i) {
    const Vec3 d = random.in_ball();
    cap.push_back(normalized(Vec3{6, 0, 8} + d * 1.5) * 10.0);
    plane.push_back(Vec3{6 + 2 * d.x, 2 * d.y, 8});
  }
  const Sheet a = fit_sheet(cap, {}, 1, SheetOrder::quadric);
  const Sheet b = fit_sheet(plane, {}, 1, SheetOrder::quadric);
  for (const Vec3& query : {Vec3{6.2, 0.3, 8.1}, Vec3{5.5, 0.8, 8.2}, Vec3{6.1, -0.6, 7.6}}) {
    const auto crease = find_crease(a, b, query);
    ASSERT_TRUE(crease);
    EXPECT_NEAR(crease->point.z, 8, 1e-6);
    EXPECT_NEAR(std::hypot(crease->point.x, crease->point.y), 6, 0.01);
    EXPECT_NEAR(std::abs(dot(crease->direction, Vec3{0, 0, 1})), 0, 1e-6);
    EXPECT_NEAR(degrees(axial_angle(crease->normal[0], crease->normal[1])), 36.87, 1);
  }
}

TEST(Crease, ParallelSheetsHaveNone) {
  const std::vector<Vec3> low = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  std::vector<Vec3> high = low;
  for (Vec3& p : high) p.z += 1 + 0.05 * p.x;
  const Sheet a = fit_sheet(low, {}, 1, SheetOrder::plane),
              b = fit_sheet(high, {}, 1, SheetOrder::plane);
  EXPECT_FALSE(find_crease(a, b, {0, 0, 0.5}));
}

TEST(Crease, CornerOfThreePlanesIsTheirPoint) {
  Random random(75);
  const Placed f = random_frame(random);
  std::array<Sheet, 3> sheets;
  for (std::size_t s = 0; s < 3; ++s) {
    std::vector<Vec3> points;
    for (int i = 0; i < 10; ++i) {
      Vec3 p{random.uniform(), random.uniform(), random.uniform()};
      p[s] = 0;
      points.push_back(f(p));
    }
    sheets[s] = fit_sheet(points, {}, 1, SheetOrder::plane);
  }
  const auto corner = find_corner({&sheets[0], &sheets[1], &sheets[2]}, f({0.3, 0.2, 0.1}));
  ASSERT_TRUE(corner);
  EXPECT_LT(distance(*corner, f.origin), 1e-9);
  EXPECT_FALSE(find_corner({&sheets[0], &sheets[1], &sheets[0]}, f.origin));
}

// Near an edge the neighborhood holds two faces; the sheet must be the one the point is on.
TEST(OwnSheet, NearAnEdgeIsTheFaceOfThePoint) {
  Random random(76);
  std::vector<char> scratch;
  int right = 0;
  constexpr int trials = 300;
  for (int trial = 0; trial < trials; ++trial) {
    const double from_edge = random.uniform(0.3, 2);
    std::vector<Vec3> points = {{-from_edge, 0, 0}};
    while (points.size() < 21) {  // two faces that meet in the y axis, within 2.5 of the point
      const double s = random.uniform(-3, 3), y = random.uniform(-3, 3);
      const Vec3 p = s < 0 ? Vec3{s, y, 0} : Vec3{0, y, -s};
      if (distance(p, points[0]) < 2.5) points.push_back(p);
    }
    const Sheet sheet = find_own_sheet(points, 1, sheet_tolerances(0), scratch);
    right += sheet.fitted() && axial_angle(normal_at(sheet, points[0]), {0, 0, 1}) < 0.05;
  }
  EXPECT_GT(right, trials * 95 / 100);
}

TEST(OwnSheet, TwoWallsOfAPlateStayApart) {
  Random random(77);
  std::vector<char> scratch;
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<Vec3> points = {{0, 0, 0}};
    for (int i = 0; i < 20; ++i)
      points.push_back({random.uniform(-2, 2), random.uniform(-2, 2), i % 2 == 0 ? 0.0 : 1.2});
    const Sheet sheet = find_own_sheet(points, 1, sheet_tolerances(0), scratch);
    EXPECT_LT(std::abs(height(sheet, {0.5, 0.5, 0})), 0.05) << trial;
    EXPECT_LT(axial_angle(sheet.n, {0, 0, 1}), 0.1) << trial;
  }
}

}  // namespace
}  // namespace spigolo
