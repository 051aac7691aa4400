// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/mesh/continuation_test.cpp - the surface between its points
#include "spigolo/mesh/continuation.h"

#include <gtest/gtest.h>

namespace spigolo {
namespace {

// Eight points of a ball of radius 10 around its top, normals in and out by turns.
SurfacePoints ring_on_ball(double error) {
  SurfacePoints surface;
  for (int i = 0; i < 8; ++i) {
    const double angle = 2 * pi * i / 8, away = i % 2 == 0 ? 0.10 : 0.13;
    const Vec3 n = {std::sin(away) * std::cos(angle), std::sin(away) * std::sin(angle),
                    std::cos(away)};
    surface.points.push_back({10 * n, i % 3 == 0 ? -n : n, 0.1});
  }
  surface.points[0].position.z += error;
  return surface;
}

SurfaceFoot at_top(const SurfacePoints& surface) {
  PointCells cells(1, 8);
  for (const SurfaceFoot& foot : surface.points) cells.insert(foot.position);
  return Continuation(surface, cells, 0.5).at({0.05, 0, 10.2}, {0, 0, 1});
}

TEST(Continuation, ArcsFollowABall) {
  const SurfaceFoot foot = at_top(ring_on_ball(0));
  ASSERT_TRUE(foot.valid());
  EXPECT_NEAR(norm(foot.position), 10, 2e-3);
  EXPECT_LT(angle_between(foot.normal, foot.position), radians(3));
}

TEST(Continuation, PointsThatDisagreeAreNoSurface) {
  EXPECT_FALSE(at_top(ring_on_ball(0.6)).valid());
  EXPECT_FALSE(at_top(SurfacePoints{}).valid());
}

TEST(Continuation, SheetsAreFollowedWhereThereAreSome) {
  SurfacePoints surface = ring_on_ball(0);
  surface.continued = [](std::uint32_t, const Vec3& query) {
    return SurfaceFoot{{query.x, query.y, 10.1}, {0, 0, 1}, 0};
  };
  EXPECT_NEAR(at_top(surface).position.z, 10.1, 1e-12);
}

}  // namespace
}  // namespace spigolo
