// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
#include "spigolo/gauss_map/feature_test.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "spigolo/core/random.h"

namespace spigolo {
namespace {

// k lattice neighbors of the origin on a roof whose half planes meet in the y axis at this interior
// angle: the neighborhood of a sample on a straight edge.
std::vector<Vec3> on_edge(double interior) {
  std::vector<Vec3> neighbors;
  const double a = interior / 2;
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j)
      if (i != 0 || j != 0)
        neighbors.push_back({i * std::sin(a), double(j), -std::abs(i) * std::cos(a)});
  return neighbors;
}

Vec3 turned(const Vec3& v) {  // by a third of a turn around (1, 1, 1), then half a radian around z
  const Vec3 w{v.z, v.x, v.y};
  const double c = std::cos(0.5), s = std::sin(0.5);
  return {c * w.x - s * w.y, s * w.x + c * w.y, w.z};
}

FeatureTest test_at_origin(const std::vector<Vec3>& neighbors) {
  FeatureTestScratch scratch;
  return test_point({0, 0, 0}, neighbors, {}, scratch);
}

TEST(FeatureTest, EdgesOfEveryAngleAreSharpAndTheirAngleIsRight) {
  for (const double angle : {30, 45, 60, 90, 110, 140, 150, 160}) {
    const auto neighbors = on_edge(radians(angle));
    const FeatureTest test = test_at_origin(neighbors);
    EXPECT_EQ(test.verdict, FeatureVerdict::sharp) << angle;
    EXPECT_EQ(test.clusters, 2) << angle;
    const double deviation = edge_deviation({0, 0, 0}, neighbors, test.normal);
    EXPECT_NEAR(degrees(deviation), 180 - angle, 0.5) << angle;
  }
}

TEST(FeatureTest, TurningTheNeighborhoodChangesNothing) {
  for (const double angle : {45, 90, 150}) {
    auto neighbors = on_edge(radians(angle));
    const FeatureTest before = test_at_origin(neighbors);
    for (Vec3& n : neighbors) n = turned(n);
    const FeatureTest after = test_at_origin(neighbors);
    EXPECT_EQ(before.verdict, after.verdict);
    EXPECT_EQ(before.clusters, after.clusters);
    EXPECT_LT(axial_angle(turned(before.normal[0]), after.normal[0]), 1e-3);
  }
}

TEST(FeatureTest, CubeCornerHasThreeClusters) {
  std::vector<Vec3> neighbors;
  for (int i = 0; i <= 2; ++i)
    for (int j = 0; j <= 2; ++j)
      for (const Vec3& n : {Vec3(i, j, 0), Vec3(i, 0, j), Vec3(0, i, j)})
        if (i + j > 0 && std::find(neighbors.begin(), neighbors.end(), n) == neighbors.end())
          neighbors.push_back(n);
  const FeatureTest test = test_at_origin(neighbors);
  EXPECT_EQ(test.verdict, FeatureVerdict::sharp);
  EXPECT_EQ(test.clusters, 3);
}

TEST(FeatureTest, PlanesAreFlatHoweverTheyAreSampled) {
  EXPECT_EQ(test_at_origin(on_edge(pi)).verdict, FeatureVerdict::flat);
  Random random(51);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<Vec3> plane;
    for (int i = 0; i < 20; ++i)
      plane.push_back(turned({random.uniform(-1, 1), random.uniform(-1, 1), 0}));
    EXPECT_EQ(test_at_origin(plane).verdict, FeatureVerdict::flat);
  }
}

TEST(FeatureTest, FewerThanThreeTrianglesAreDegenerate) {
  EXPECT_EQ(test_at_origin({}).verdict, FeatureVerdict::degenerate);
  EXPECT_EQ(test_at_origin({{1, 0, 0}, {0, 1, 0}}).verdict, FeatureVerdict::degenerate);
  std::vector<Vec3> line;
  for (int i = 1; i < 20; ++i) line.push_back({double(i), 2.0 * i, 0});
  EXPECT_EQ(test_at_origin(line).verdict, FeatureVerdict::degenerate);
}

}  // namespace
}  // namespace spigolo
