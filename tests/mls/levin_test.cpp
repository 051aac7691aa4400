// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
#include "spigolo/mls/levin.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "spigolo/core/error.h"
#include "spigolo/core/random.h"
#include "spigolo/synth/synth.h"
#include "support/clouds.h"

namespace spigolo {
namespace {

// A frame in general position, so that no axis of the coordinates helps.
struct Placed {
  Vec3 x, y, z, origin;
  Vec3 operator()(const Vec3& p) const { return origin + x * p.x + y * p.y + z * p.z; }
};

Placed placed(std::uint64_t seed) {
  Random random(seed);
  const Vec3 z = random.on_sphere(), x = any_perpendicular(z);
  return {x, cross(z, x), z, random.in_ball() * 100.0};
}

// Samples of a height field over [-10, 10]^2, one in a unit of area.
template <class Height>
std::vector<Vec3> height_field(const Placed& frame, bool lattice, const Height& height,
                               std::uint64_t seed) {
  Random random(seed);
  std::vector<Vec3> points;
  for (int i = 0; i < 400; ++i) {
    const double x = lattice ? i % 20 - 9.5 : random.uniform(-10, 10);
    const double y = lattice ? i / 20 - 9.5 : random.uniform(-10, 10);
    points.push_back(frame({x, y, height(x, y)}));
  }
  return points;
}

SurfacePoint plain(const MlsCloud& cloud, const Vec3& query, const MlsOptions& options = {}) {
  MlsScratch scratch;
  return project_plain(cloud, query, settle(options, cloud.noise()), scratch);
}

TEST(Levin, PlanesAreReproduced) {
  for (const bool lattice : {true, false}) {
    const Placed frame = placed(81);
    const MlsCloud cloud(height_field(
        frame, lattice, [](double, double) { return 0.0; }, 5));
    Random random(82);
    for (int i = 0; i < 200; ++i) {
      const double x = random.uniform(-9, 9), y = random.uniform(-9, 9);
      const SurfacePoint s = plain(cloud, frame({x, y, random.uniform(-2, 2)}));
      ASSERT_EQ(s.status, SurfaceStatus::sheet);
      EXPECT_LT(distance(s.position, frame({x, y, 0})), 1e-9);
      EXPECT_LT(axial_angle(s.normal, frame.z), 1e-8);
      EXPECT_NEAR(s.curvature[0], 0, 1e-7);
      EXPECT_NEAR(s.curvature[1], 0, 1e-7);
    }
  }
}

TEST(Levin, QuadraticHeightFieldsAreNearlyReproduced) {
  const auto height = [](double x, double y) {
    return 0.01 * x * x - 0.006 * y * y + 0.004 * x * y;
  };
  for (const bool lattice : {true, false}) {
    const Placed frame = placed(83);
    const MlsCloud cloud(height_field(frame, lattice, height, 6));
    Random random(84);
    for (int i = 0; i < 200; ++i) {
      const double x = random.uniform(-5, 5), y = random.uniform(-5, 5);
      const SurfacePoint s = plain(cloud, frame({x, y, height(x, y) + random.uniform(-0.3, 0.3)}));
      const Vec3 d = s.position - frame.origin;
      // The frame leans with the surface: what is left is of third order.
      EXPECT_NEAR(dot(d, frame.z), height(dot(d, frame.x), dot(d, frame.y)), 1e-4);
    }
  }
}

TEST(Levin, CurvatureOfSphereCylinderAndSaddle) {
  const double radius = 10;
  const MlsCloud sphere(test::random_sphere(2000, 7, radius));
  const Vec3 q = normalized(Vec3{1, 2, 3}) * (radius + 0.1);
  const SurfacePoint s = plain(sphere, q);
  EXPECT_LT(distance(s.position, normalized(q) * radius), 2e-3 * radius);
  const double inward = dot(s.normal, q) < 0 ? 1 : -1;
  EXPECT_NEAR(inward * s.curvature[0], 1 / radius, 0.05 / radius);
  EXPECT_NEAR(inward * s.curvature[1], 1 / radius, 0.05 / radius);

  const Placed frame = placed(85);
  const auto saddle = [](double x, double y) { return 0.02 * x * x - 0.01 * y * y; };
  const MlsCloud cloud(height_field(frame, true, saddle, 8));
  const SurfacePoint at = plain(cloud, frame.origin);
  const double up = dot(at.normal, frame.z) > 0 ? 1 : -1;
  EXPECT_NEAR(up * (at.curvature[0] + at.curvature[1]), 0.02, 1e-3);
  EXPECT_NEAR(at.curvature[0] * at.curvature[1], -0.04 * 0.02, 5e-5);
  EXPECT_GE(at.curvature[0], at.curvature[1]);
}

TEST(Levin, ProjectingTwiceIsProjectingOnce) {
  SynthOptions options;
  options.shape = "torus";
  options.noise = 0.35;
  options.points = 5000;
  const SynthCloud s = make_cloud(options);
  const MlsCloud cloud(s.cloud.points);
  for (std::size_t i = 0; i < s.cloud.size(); i += 50) {
    const SurfacePoint once = plain(cloud, s.cloud.points[i]);
    ASSERT_TRUE(on_surface(once.status));
    EXPECT_LT(distance(plain(cloud, once.position).position, once.position), 0.02 * s.spacing);
  }
}

TEST(Levin, NoiseIsSmoothedAway) {
  SynthOptions options;
  options.shape = "sphere";
  options.noise = 0.35;
  options.points = 10000;
  const SynthCloud s = make_cloud(options);
  const MlsCloud cloud(s.cloud.points);
  double squares = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < s.cloud.size(); i += 10, ++count) {
    const double d = surface_distance(s.shape, plain(cloud, s.cloud.points[i]).position);
    squares += d * d;
  }
  EXPECT_LT(std::sqrt(squares / static_cast<double>(count)), 0.35 * 0.35 * s.spacing);
}

TEST(Levin, SmallWeightsDoNotVanish) {
  // h = 0.05: next to one sample, all other weights are below the smallest double.
  const Placed frame = placed(86);
  const MlsCloud cloud(height_field(
      frame, false, [](double, double) { return 0.0; }, 9));
  MlsOptions options;
  options.smoothing = 0.05;
  Random random(87);
  for (int i = 0; i < 300; ++i) {
    const double x = random.uniform(-9, 9), y = random.uniform(-9, 9);
    const SurfacePoint s = plain(cloud, frame({x, y, random.uniform(-1, 1)}), options);
    ASSERT_EQ(s.status, SurfaceStatus::sheet);
    EXPECT_LT(distance(s.position, frame({x, y, 0})), 1e-8);
  }
}

TEST(Levin, ScaleMotionAndOrderChangeNothing) {
  SynthOptions options;
  options.shape = "cylinder";
  options.points = 3000;
  options.noise = 0.1;
  const auto points = make_cloud(options).cloud.points;
  const Placed frame = placed(88);
  std::vector<Vec3> other;
  for (const Vec3& p : points) other.push_back(frame(p * 1000.0));
  const MlsCloud a(points), b(test::shuffled(other, 3)), same(test::shuffled(points, 4));
  for (std::size_t i = 0; i < points.size(); i += 37) {
    const SurfacePoint s = plain(a, points[i]), t = plain(b, frame(points[i] * 1000.0));
    EXPECT_LT(distance(frame(s.position * 1000.0), t.position), 1e-3 * a.spacing() * 1000);
    EXPECT_NEAR(s.curvature[0] - s.curvature[1], 1000 * (t.curvature[0] - t.curvature[1]),
                1e-3 / a.spacing());
    EXPECT_EQ(plain(same, points[i]).position, s.position);
  }
}

TEST(Levin, QueriesWithoutResultSaySo) {
  const MlsCloud cloud(test::random_square(500, 3));
  const double s = cloud.spacing();
  EXPECT_EQ(plain(cloud, {0.5, 0.5, 5 * s}).status, SurfaceStatus::sheet);
  for (const Vec3& query : {Vec3{0.5, 0.5, 20 * s}, Vec3{1e6, 0, 0}, Vec3{0, 1e200, 0}}) {
    const SurfacePoint far = plain(cloud, query);
    EXPECT_EQ(far.status, SurfaceStatus::too_far);
    EXPECT_EQ(far.position, query);
    EXPECT_EQ(far.normal, Vec3{});
  }
  const SurfacePoint odd = plain(cloud, {not_a_number, 0, 0});
  EXPECT_EQ(odd.status, SurfaceStatus::degenerate);
  EXPECT_EQ(odd.normal, Vec3{});
}

TEST(Levin, HardCloudsGiveNumbersOrAReason) {
  for (const auto& [name, points] : test::hard_clouds()) {
    SCOPED_TRACE(name);
    try {
      const MlsCloud cloud(points);
      for (std::size_t i = 0; i < points.size(); i += 7) {
        const SurfacePoint s = plain(cloud, points[i]);
        EXPECT_TRUE(is_finite(s.position) && is_finite(s.normal));
        EXPECT_TRUE(std::isfinite(s.curvature[0]) && std::isfinite(s.curvature[1]));
        EXPECT_NEAR(norm(s.normal), on_surface(s.status) ? 1 : 0, 1e-9);
      }
    } catch (const NoResultError&) {
      EXPECT_TRUE(name == "line" || name == "one" || name == "two" || name == "equal");
    }
  }
}

TEST(Levin, TooFewNeighborsAreAPlaneOrNothing) {
  MlsScratch scratch;
  const std::vector<Vec3> five = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}};
  const Vec3 p{0.5, 0.4, 0.3};
  const SurfacePoint plane = project_levin(p, five, 1, scratch);
  EXPECT_EQ(plane.status, SurfaceStatus::sheet);
  EXPECT_LT(distance(plane.position, {0.5, 0.4, 0}), 1e-9);
  EXPECT_EQ(project_levin(p, std::span(five).first(2), 1, scratch).status, SurfaceStatus::too_few);
  const std::vector<Vec3> line = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {4, 4, 4}, {5, 5, 5}};
  EXPECT_EQ(project_levin(p, line, 1, scratch).status, SurfaceStatus::degenerate);
  const std::vector<Vec3> same(8, Vec3{1, 1, 1});
  EXPECT_EQ(project_levin(p, same, 1, scratch).status, SurfaceStatus::degenerate);
}

TEST(Levin, OptionsOutOfRangeAreRefused) {
  MlsOptions options;
  options.smoothing = -1;
  EXPECT_THROW(settle(options, 0), UsageError);
  options = {};
  options.k = 5;
  EXPECT_THROW(settle(options, 0), UsageError);
  options = {};
  options.reach = not_a_number;
  EXPECT_THROW(settle(options, 0), UsageError);
  EXPECT_EQ(settle({}, 0).k, 20u);
  EXPECT_GT(settle({}, 0.35).smoothing, settle({}, 0.1).smoothing);
}

TEST(Levin, OrientedFootKnowsItsSide) {
  const MlsCloud cloud(test::square_lattice(20));
  const Vec3 above{9.3, 9.6, 0.5}, below{9.3, 9.6, -0.25}, up{0.2, 0, 3};
  const OrientedFoot a = orient_foot(plain(cloud, above), above, up);
  const OrientedFoot b = orient_foot(plain(cloud, below), below, up);
  EXPECT_TRUE(a.found && b.found);
  EXPECT_NEAR(a.distance, 0.5, 1e-9);
  EXPECT_NEAR(b.distance, -0.25, 1e-9);
  EXPECT_LT(distance(b.normal, {0, 0, 1}), 1e-9);
  const Vec3 far{0, 0, 1e5};
  EXPECT_FALSE(orient_foot(plain(cloud, far), far, up).found);
}

}  // namespace
}  // namespace spigolo
