// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// NURBS data: (2.22) to (2.24) against closed forms
#include <gtest/gtest.h>

#include <cmath>

#include "spigolo/cad/nurbs_shapes.h"
#include "spigolo/cad/spline_rows.h"
#include "spigolo/core/error.h"
#include "spigolo/core/random.h"

namespace spigolo {
namespace {

const Vec3 ex{1, 0, 0}, ey{0, 1, 0}, ez{0, 0, 1};

std::vector<double> some_knots(int degree, std::size_t poles, Random& random) {
  std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0);
  for (std::size_t i = static_cast<std::size_t>(degree) + 1; i < poles; ++i)
    knots.push_back(knots.back() + random.uniform(0.01, 1));
  knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, knots.back() + 0.5);
  return knots;
}

TEST(Basis, sumsToOneAndItsDerivativesToZero) {
  Random random(3);
  for (int degree = 1; degree <= 7; ++degree) {
    const std::vector<double> knots = some_knots(degree, 12, random);
    for (int i = 0; i <= 200; ++i) {
      const double t = knots.back() * i / 200;
      const BasisFunctions basis = basis_functions(knots, degree, t);
      double sum = 0, slope = 0;
      for (int k = 0; k <= degree; ++k) {
        EXPECT_GE(basis.value[static_cast<std::size_t>(k)], -1e-15);
        sum += basis.value[static_cast<std::size_t>(k)];
        slope += basis.derivative[static_cast<std::size_t>(k)];
      }
      EXPECT_NEAR(sum, 1, 1e-14);
      EXPECT_NEAR(slope, 0, 1e-10);
    }
  }
}

// (2.23) word by word.
double by_recursion(const std::vector<double>& t, std::size_t i, int k, double x) {
  if (k == 0) return t[i] <= x && x < t[i + 1] ? 1 : 0;
  const auto n = static_cast<std::size_t>(k);
  const auto term = [](double up, double down, double f) { return down > 0 ? up / down * f : 0; };
  return term(x - t[i], t[i + n] - t[i], by_recursion(t, i, k - 1, x)) +
         term(t[i + n + 1] - x, t[i + n + 1] - t[i + 1], by_recursion(t, i + 1, k - 1, x));
}

TEST(Basis, isTheRecursionOfTheText) {
  Random random(4);
  for (int degree = 1; degree <= 4; ++degree) {
    const std::vector<double> knots = some_knots(degree, 9, random);
    for (int trial = 0; trial < 100; ++trial) {
      const double x = random.uniform(0, knots.back());
      const BasisFunctions basis = basis_functions(knots, degree, x);
      for (std::size_t i = 0; i < 9; ++i) {
        const bool there = i >= basis.first && i <= basis.first + static_cast<std::size_t>(degree);
        EXPECT_NEAR(there ? basis.value[i - basis.first] : 0, by_recursion(knots, i, degree, x),
                    1e-13);
      }
    }
  }
}

TEST(Curve, circleIsExact) {
  const Vec3 center{1, -2, 3}, x = normalized(Vec3{1, 2, 2}), y = any_perpendicular(x);
  const NurbsCurve circle = nurbs_circle(center, x, y, 2.5);
  validate(circle);
  for (int i = 0; i <= 1000; ++i) {
    const CurvePoint p = evaluate(circle, i / 1000.0);
    EXPECT_NEAR(distance(p.point, center), 2.5, 1e-14);
    EXPECT_NEAR(dot(p.point - center, cross(x, y)), 0, 1e-14);
    EXPECT_NEAR(dot(p.derivative, p.point - center), 0, 1e-12);
  }
  EXPECT_NEAR(distance(point_at(circle, 0.25), center + y * 2.5), 0, 1e-14);
}

TEST(Curve, derivativeIsThatOfDifferences) {
  Random random(5);
  NurbsCurve curve;
  curve.knots = some_knots(3, 10, random);
  for (int i = 0; i < 10; ++i) {
    curve.poles.push_back(random.in_ball());
    curve.weights.push_back(random.uniform(0.3, 3));
  }
  validate(curve);
  for (int trial = 0; trial < 200; ++trial) {
    const double t = random.uniform(0.01, curve.knots.back() - 0.01), h = 1e-6;
    const Vec3 slope = (point_at(curve, t + h) - point_at(curve, t - h)) / (2 * h);
    EXPECT_LT(distance(slope, evaluate(curve, t).derivative), 1e-6);
  }
}

TEST(Surface, tubeConeAndUTubeAreExact) {
  const TubeFrame frame{{1, 2, 3}, normalized(Vec3{1, 1, 3})};
  const NurbsSurface tube = nurbs_tube(frame, 2, 7);
  const NurbsSurface cone = nurbs_cone(frame, 2, 0.5, 6);
  validate(tube);
  Random random(6);
  for (int i = 0; i < 300; ++i) {
    const double u = random.uniform(-1, 2), v = random.uniform();
    const Vec3 a = point_at(tube, u, v) - frame.origin, b = point_at(cone, u, v) - frame.origin;
    EXPECT_NEAR(dot(a, frame.axis), 7 * v, 1e-13);
    EXPECT_NEAR(norm(a - frame.axis * dot(a, frame.axis)), 2, 1e-13);
    EXPECT_NEAR(norm(b - frame.axis * dot(b, frame.axis)), 2 - 1.5 * v, 1e-13);
    const Vec3 out = normalized(a - frame.axis * dot(a, frame.axis));
    EXPECT_LT(distance(normal_at(tube, u, v), out), 1e-12);
  }
  const NurbsSurface bent = nurbs_u_tube({{0, 0, 0}, ez}, ex, 1, 4, 5);
  validate(bent);
  for (int i = 0; i < 300; ++i) {
    const Vec3 p = point_at(bent, random.uniform(), random.uniform());
    const Vec3 flat{p.x - 2.5, 0, p.z - 4};
    const double r =
        p.z > 4 ? std::hypot(norm(flat) - 2.5, p.y) : std::hypot(std::abs(p.x - 2.5) - 2.5, p.y);
    EXPECT_NEAR(r, 1, 1e-13) << p.x << " " << p.y << " " << p.z;
  }
}

TEST(Surface, normalAtTheTipOfACone) {
  const NurbsSurface cone = nurbs_cone({{0, 0, 0}, ez}, 1, 0, 1);
  EXPECT_NEAR(norm(normal_at(cone, 0.3, 1)), 1, 1e-12);
}

TEST(SplineRows, reproducesLinesAndPassesThroughItsPoints) {
  Random random(7);
  std::vector<Vec3> points;
  for (int i = 0; i < 12; ++i) points.push_back(random.on_sphere());
  for (const bool closed : {false, true}) {
    const NurbsCurve curve = spline_through(points, closed);
    validate(curve);
    double found = 0;
    for (const Vec3& p : points) {
      double nearest = infinity;
      for (int i = 0; i <= 20000; ++i)
        nearest = std::min(nearest, distance(p, point_at(curve, i / 20000.0)));
      found = std::max(found, nearest);
    }
    EXPECT_LT(found, 1e-3);
  }
  const NurbsCurve line = spline_through(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {4, 0, 0}}, false);
  EXPECT_LT(distance(point_at(line, 0.5), {2, 0, 0}), 1e-14);
  EXPECT_THROW(spline_through(std::vector<Vec3>{{0, 0, 0}, {0, 0, 0}}, false), Error);
}

TEST(SplineRows, circleWithinAThousandthAndSmoothAtItsKnots) {
  std::vector<StripPoles> strips;
  for (int i = 0; i < 40; ++i) {
    const Vec3 p{std::cos(i * pi / 20), std::sin(i * pi / 20), 0};
    strips.push_back({p, p + ez * (1.0 / 3), p + ez * (2.0 / 3), p + ez});
  }
  std::vector<double> station;
  const NurbsSurface s = surface_through(strips, true, &station);
  validate(s);
  ASSERT_EQ(station.size(), 40u);
  for (std::size_t i = 0; i < 40; ++i) {
    EXPECT_LT(distance(point_at(s, station[i], 0), strips[i][0]), 1e-13);
    EXPECT_LT(angle_between(evaluate(s, station[i] - 1e-9, 0.5).du,
                            evaluate(s, station[i] + 1e-9, 0.5).du),
              1e-6);
  }
  for (int i = 0; i < 500; ++i) EXPECT_NEAR(norm(point_at(s, i / 500.0, 0)), 1, 1e-4);
}

TEST(Surface, refusesWhatDoesNotFit) {
  NurbsSurface tube = nurbs_tube({{0, 0, 0}, ez}, 1, 1);
  tube.weights[3] = 0;
  EXPECT_THROW(validate(tube), Error);
  tube = nurbs_tube({{0, 0, 0}, ez}, 1, 1);
  tube.poles.pop_back();
  EXPECT_THROW(validate(tube), Error);
  tube = nurbs_tube({{0, 0, 0}, ez}, 1, 1);
  std::swap(tube.knots_u.front(), tube.knots_u.back());
  EXPECT_THROW(validate(tube), Error);
}

}  // namespace
}  // namespace spigolo
