// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// trace: splines, circles and lines through points that lie on known curves
#include "spigolo/trace/spline.h"

#include <gtest/gtest.h>

#include <cmath>

#include "spigolo/core/error.h"
#include "spigolo/core/random.h"
#include "spigolo/trace/local_fit.h"
#include "spigolo/trace/recognize.h"

namespace spigolo::test {
namespace {

std::vector<Vec3> helix(int n, double turns) {
  std::vector<Vec3> points;
  for (int i = 0; i < n; ++i) {
    const double t = turns * 2 * pi * i / (n - 1);
    points.push_back({10 * std::cos(t), 10 * std::sin(t), t});
  }
  return points;
}

double farthest(const std::vector<Vec3>& points, const CurveSpline& spline) {
  double most = 0;
  for (const Vec3& p : points) {
    double least = infinity;
    for (int i = 0; i <= 4000; ++i)
      least = std::min(least, distance(p, value(spline, last_parameter(spline) * i / 4000)));
    most = std::max(most, least);
  }
  return most;
}

TEST(Spline, staysWithinToleranceAndMeetsTheEndsExactly) {
  const std::vector<Vec3> points = helix(120, 1.5);
  for (const double tolerance : {0.5, 0.05, 0.005}) {
    const CurveSpline spline = fit_spline(points, false, tolerance);
    EXPECT_LE(farthest(points, spline), tolerance + 0.02);
    EXPECT_EQ(value(spline, first_parameter(spline)), points.front());
    EXPECT_LT(distance(value(spline, last_parameter(spline)), points.back()), 1e-12);
    EXPECT_EQ(spline.knots.size(), spline.poles.size() + 4);
  }
}

TEST(Spline, aLooserToleranceNeedsFewerPoles) {
  const std::vector<Vec3> points = helix(200, 2);
  EXPECT_LT(fit_spline(points, false, 0.5).poles.size(),
            fit_spline(points, false, 0.005).poles.size());
}

TEST(Spline, closedOnesCloseSmoothly) {
  std::vector<Vec3> points;
  for (int i = 0; i < 100; ++i) {
    const double t = 2 * pi * i / 100;
    points.push_back({12 * std::cos(t), 7 * std::sin(t), std::sin(2 * t)});
  }
  const CurveSpline spline = fit_spline(points, true, 0.01);
  const double end = last_parameter(spline), h = 1e-4 * end;
  EXPECT_EQ(spline.poles.front(), spline.poles.back());
  EXPECT_LE(farthest(points, spline), 0.03);
  const Vec3 leaving = (value(spline, h) - value(spline, 0)) / h;
  const Vec3 arriving = (value(spline, end) - value(spline, end - h)) / h;
  EXPECT_LT(angle_between(leaving, arriving), 0.01);
}

TEST(Spline, insertingAKnotMovesNoPoint) {
  CurveSpline spline = fit_spline(helix(50, 0.7), false, 0.01);
  const CurveSpline before = spline;
  for (const double share : {0.11, 0.5, 0.5, 0.93})
    insert_knot(spline, share * last_parameter(spline));
  EXPECT_EQ(spline.poles.size(), before.poles.size() + 4);
  for (int i = 0; i <= 100; ++i) {
    const double t = last_parameter(spline) * i / 100;
    EXPECT_LT(distance(value(spline, t), value(before, t)), 1e-11);
  }
}

TEST(Spline, twoPointsAreASegment) {
  const std::vector<Vec3> points = {{0, 0, 0}, {3, 4, 0}};
  const CurveSpline spline = fit_spline(points, false, 0.1);
  EXPECT_LT(distance(value(spline, last_parameter(spline) / 2), {1.5, 2, 0}), 1e-6);
  EXPECT_THROW(fit_spline({points.data(), 1}, false, 0.1), Error);
  EXPECT_THROW(fit_spline(points, true, 0.1), Error);
}

TEST(Circle, isFoundThroughStrays) {
  Random random(3);
  const Vec3 center{4, -2, 9}, axis = normalized(Vec3{1, 1, 2});
  const Vec3 x = any_perpendicular(axis), y = cross(axis, x);
  std::vector<Vec3> points;
  for (int i = 0; i < 80; ++i) {
    const double t = 2 * pi * i / 80;
    points.push_back(center + (x * std::cos(t) + y * std::sin(t)) * 15.0);
    if (i % 9 == 0) points.back() += random.on_sphere() * 0.5;
  }
  const auto circle = fit_circle(points, 1e-6);
  ASSERT_TRUE(circle);
  EXPECT_NEAR(circle->radius, 15, 1e-5);
  EXPECT_LT(distance(circle->center, center), 1e-5);
  EXPECT_LT(axial_angle(circle->axis, axis), 1e-5);
}

TEST(Circle, throughThreePoints) {
  const auto circle = circle_through({1, 0, 5}, {0, 1, 5}, {-1, 0, 5});
  ASSERT_TRUE(circle);
  EXPECT_LT(distance(circle->center, {0, 0, 5}), 1e-14);
  EXPECT_NEAR(circle->radius, 1, 1e-14);
  EXPECT_FALSE(circle_through({0, 0, 0}, {1, 0, 0}, {2, 0, 0}));
}

TEST(Circle, pointsOnALineHaveNone) {
  std::vector<Vec3> points;
  for (int i = 0; i < 30; ++i) points.push_back({double(i), 2.0 * i, 1});
  EXPECT_FALSE(fit_circle(points, 1e-6));
}

TEST(Line, isFoundThroughStrays) {
  std::vector<Vec3> points;
  for (int i = 0; i < 40; ++i) points.push_back({double(i), i % 7 == 3 ? 0.4 : 0.0, 2});
  const LineFit line = fit_line(points, 1e-6);
  EXPECT_LT(angle_between(line.direction, {1, 0, 0}), 1e-5);
  EXPECT_NEAR(line.place.y, 0, 1e-4);
}

TEST(LocalCurve, reproducesAParabola) {
  std::vector<Vec3> points;
  for (int i = -5; i <= 5; ++i) points.push_back({double(i), 0.02 * i * i, 0.01 * i * i + 1});
  const LocalCurve curve = fit_local_curve(points, {0.3, 0, 1}, {1, 0, 0});
  EXPECT_NEAR(curve.place.x, 0.3, 1e-12);
  EXPECT_NEAR(curve.place.y, 0.02 * 0.09, 1e-9);
  EXPECT_NEAR(curve.place.z, 1 + 0.01 * 0.09, 1e-9);
}

// Uneven points off a line: halved spans once held none, and the spline left the points by far.
TEST(Spline, staysAmongUnevenPoints) {
  Random random(3);
  for (int round = 0; round < 200; ++round) {
    std::vector<Vec3> points;
    double x = 0, length = 0;
    for (int i = 0; i < 30; ++i) {
      x += random.uniform() < 0.2 ? 3 : 0.1 + 0.4 * random.uniform();
      points.push_back({x, 0.6 * random.uniform(), 0.6 * random.uniform()});
      if (i > 0) length += distance(points[points.size() - 2], points.back());
    }
    const CurveSpline spline = fit_spline(points, false, 0.05);
    for (double t = 0; t < last_parameter(spline); t += 0.1) {
      const Vec3 p = value(spline, t);
      ASSERT_LT(std::hypot(p.y, p.z), 5) << round;
    }
  }
}

}  // namespace
}  // namespace spigolo::test
