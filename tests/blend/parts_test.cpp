// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// The parts of a blend: starts, distances, scattering, elimination, strips
#include <gtest/gtest.h>

#include <algorithm>

#include "blend/scenes.h"
#include "spigolo/blend/collar.h"
#include "spigolo/blend/curve_distance.h"
#include "spigolo/blend/eliminate.h"
#include "spigolo/blend/handles.h"
#include "spigolo/blend/rolling_ball.h"
#include "spigolo/blend/scatter.h"
#include "spigolo/blend/smooth_row.h"
#include "spigolo/core/error.h"

namespace spigolo::test {
namespace {

const FixedPoints nothing_fixed = [](const Vec3&, double, const auto&) {};

TEST(Starts, areReadAsDocumented) {
  const BlendStart border = parse_start("v1"), iso = parse_start("u=0.4-");
  EXPECT_TRUE(border.border);
  EXPECT_EQ(border.along, Parameter::v);
  EXPECT_EQ(border.direction, -1);
  EXPECT_FALSE(iso.border);
  EXPECT_EQ(iso.along, Parameter::u);
  EXPECT_EQ(iso.share, 0.4);
  EXPECT_EQ(iso.direction, -1);
  for (const char* bad : {"", "w0", "u2", "u=", "u=0.4", "u=1.4+", "u=x+", "v=0.5*", "u0 "})
    EXPECT_THROW(parse_start(bad), UsageError) << bad;
}

TEST(Options, contradictionsAreRefused) {
  BlendOptions options = from({"v1"}, -1);
  EXPECT_THROW(check_options(options), UsageError);
  options.radius = 3, options.height = 2, options.width = 2;
  EXPECT_THROW(check_options(options), UsageError);
  options.radius = 0, options.width = 0;
  EXPECT_THROW(check_options(options), UsageError);
  options.width = 2;
  EXPECT_NO_THROW(check_options(options));
}

TEST(CurveDistance, isThatOfBruteForce) {
  Random random(3);
  std::vector<Vec3> curve;
  for (int i = 0; i < 100; ++i)
    curve.push_back({std::cos(i * pi / 50), std::sin(i * pi / 50), 0.3 * std::cos(i * pi / 25)});
  const CurveDistance distances(curve, true);
  std::vector<Neighbor> scratch;
  for (int trial = 0; trial < 500; ++trial) {
    const Vec3 p = random.in_ball() * 2.0;
    double brute = infinity;
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const Vec3 &a = curve[i], way = curve[(i + 1) % curve.size()] - a;
      const double share = std::clamp(dot(p - a, way) / squared_norm(way), 0.0, 1.0);
      brute = std::min(brute, distance(p, a + way * share));
    }
    EXPECT_NEAR(distances.nearest(p, scratch).distance, brute, 2e-3);
  }
  EXPECT_NEAR(distances.nearest(curve[7], scratch).distance, 0, 1e-15);
}

TEST(Scatter, isUniformByArea) {
  // A cone's side: rows run round, columns from the tip; area grows with the square.
  const CellGrid grid{64, 16, [](double row, double column) {
                        const double a = row * 2 * pi / 64, r = column / 16;
                        return Vec3{r * std::cos(a), r * std::sin(a), r};
                      }};
  Random random(5);
  double area = 0;
  const std::vector<GridPlace> places = scatter(grid, 10000, random, area, {});
  EXPECT_NEAR(area, pi * std::sqrt(2.0), 0.01);
  EXPECT_NEAR(static_cast<double>(places.size()), 10000 * area, 1.5);
  const auto inner =
      std::count_if(places.begin(), places.end(), [](const GridPlace& p) { return p.column < 8; });
  EXPECT_NEAR(static_cast<double>(inner) / static_cast<double>(places.size()), 0.25, 0.01);
}

TEST(Eliminate, keepsTheWantedNumberEvenlyInAnyOrder) {
  Random random(7);
  std::vector<Vec3> candidates;
  for (int i = 0; i < 6000; ++i)
    candidates.push_back({random.uniform(0, 30), random.uniform(0, 30), 0});
  const auto left = [&](const std::vector<Vec3>& from) {
    const std::vector<char> stays = eliminate(from, 900, 1, nothing_fixed, {});
    std::vector<Vec3> out;
    for (std::size_t i = 0; i < from.size(); ++i)
      if (stays[i]) out.push_back(from[i]);
    std::sort(out.begin(), out.end(),
              [](const Vec3& a, const Vec3& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    return out;
  };
  const std::vector<Vec3> kept = left(candidates);
  EXPECT_NEAR(static_cast<double>(kept.size()), 900, 20);
  for (const std::uint64_t seed : {1u, 2u, 3u}) EXPECT_EQ(kept, left(shuffled(candidates, seed)));
  double least = infinity;
  for (std::size_t i = 0; i < kept.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) least = std::min(least, distance(kept[i], kept[j]));
  EXPECT_GT(least, 0.7);
  for (const Vec3& p : candidates) {
    double nearest = infinity;
    for (const Vec3& q : kept) nearest = std::min(nearest, distance(p, q));
    EXPECT_LE(nearest, 1);
  }
}

TEST(Eliminate, givesWayToFixedPoints) {
  Random random(8);
  std::vector<Vec3> candidates;
  for (int i = 0; i < 3000; ++i)
    candidates.push_back({random.uniform(0, 20), random.uniform(0, 20), 0});
  const FixedPoints row = [](const Vec3& p, double radius, const auto& visit) {
    const double d = std::abs(p.x - std::round(p.x)), h = std::abs(p.y - 10);
    if (d * d + h * h < radius * radius) visit(d * d + h * h);
  };
  const std::vector<char> stays = eliminate(candidates, 400, 1, row, {});
  int near = 0;
  for (std::size_t i = 0; i < candidates.size(); ++i)
    near += stays[i] &&
            std::hypot(candidates[i].x - std::round(candidates[i].x), candidates[i].y - 10) < 0.5;
  EXPECT_EQ(near, 0);
}

TEST(Collar, stripOfARightAngleIsTangentAndNearlyRound) {
  Strand s;
  s.x = {0, 0, 0};
  s.angle = pi / 2;
  s.alpha = {0, 0, 4}, s.alpha_normal = ex, s.toward_face = ez;
  s.beta = {4, 0, 0}, s.beta_normal = ez, s.toward_cloud = ex;
  point_to_crossing(s);
  const StripPoles strip = tangent_strip(s);
  EXPECT_EQ(strip[1].x, 0);
  EXPECT_EQ(strip[2].z, 0);
  EXPECT_NEAR(strip[1].z, 4 - 4 * 1.1 * 0.5522847, 1e-6);
}

TEST(RoundCorners, keepsLinesAndWideBendsAndRoundsCorners) {
  std::vector<Vec3> line, circle, corner;
  for (int i = 0; i < 60; ++i) {
    line.push_back({0.4 * i, 2, 3});
    circle.push_back({6 * std::cos(2 * pi * i / 60), 6 * std::sin(2 * pi * i / 60), 0});
    corner.push_back(i < 30 ? Vec3{0.3 * (i - 30), 0, 0} : Vec3{0, 0.3 * (i - 30), 0});
  }
  const auto largest_move = [](const std::vector<Vec3>& row, bool closed) {
    const std::vector<Vec3> moved = round_corners(row, 1, closed);
    double most = 0;
    for (std::size_t i = 0; i < row.size(); ++i) most = std::max(most, distance(row[i], moved[i]));
    return most;
  };
  EXPECT_LT(largest_move(line, false), 1e-12);
  EXPECT_LT(largest_move(circle, true), 6 * 2e-4);  // 6 (1 - exp(-1/72))^2
  const double at_corner = largest_move(corner, false);
  EXPECT_GT(at_corner, 0.15);
  EXPECT_LT(at_corner, 0.35);
}

// A tube that leans over a plane: the ball's center is R over both.
TEST(RollingBall, touchesFaceAndCloudAtItsRadius) {
  const double lean = radians(50);
  const Vec3 axis{std::cos(lean), 0, std::sin(lean)}, foot{20.3, 20.3, 0};
  const NurbsFace face = face_of(nurbs_tube({foot - axis * 15.0, axis}, 5, 40));
  const Isolines isolines(face, parse_start("v1"));
  const CloudSide cloud(plane(41));
  const Vec3 origin = cloud.mls().origin();
  BorderLoop loop;
  loop.closed = true;
  for (int i = 0; i < 40; ++i) {
    Strand s;
    s.line = *isolines.line(i / 40.0);
    // Where the isoline meets the plane.
    double low = s.line.end, high = s.line.begin;
    for (int k = 0; k < 60; ++k) {
      const double middle = (low + high) / 2;
      (isolines.at(s.line.cross, middle).point.z < 0 ? low : high) = middle;
    }
    s.at = low;
    const IsoPoint p = isolines.at(s.line.cross, s.at);
    s.x = p.point, s.face_normal = p.normal, s.cloud_normal = ez;
    s.radius = 3 + std::cos(2 * pi * i / 40);
    loop.strands.push_back(s);
  }
  const Vec3 outward = loop.strands[0].x - foot;
  loop.side = dot(loop.strands[0].face_normal, outward) > 0 ? 1 : -1;
  ASSERT_EQ(origin, (Vec3{20, 20, 0}));
  NurbsFace shifted = face;
  for (Vec3& pole : shifted.surface.poles) pole -= origin;
  for (Strand& s : loop.strands) s.x -= origin;
  set_directions(loop);
  const Isolines lines(shifted, parse_start("v1"));
  EXPECT_EQ(roll_ball(lines, cloud, loop, {}).patched, 0u);
  for (const Strand& s : loop.strands) {
    const Vec3 center = s.alpha + s.alpha_normal * (loop.side * s.radius);
    EXPECT_NEAR(distance(center, s.alpha), s.radius, 1e-9);
    EXPECT_NEAR(center.z, s.radius, 1e-5);
    EXPECT_NEAR(distance(center, s.beta), s.radius, 1e-5);
    EXPECT_NEAR(dot(s.alpha_handle, s.alpha_normal), 0, 1e-9);
    EXPECT_NEAR(s.beta_handle.z, 0, 1e-9);
  }
}

}  // namespace
}  // namespace spigolo::test
