// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
#include "spigolo/sheets/own_sheet.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "spigolo/core/random.h"
#include "spigolo/index/prepared_cloud.h"
#include "spigolo/sheets/local_noise.h"
#include "spigolo/synth/synth.h"

namespace spigolo {
namespace {

// Two bent walls one spacing apart: no plane holds more of one of them than of both.
TEST(OwnSheet, FollowsOneOfTwoBentWallsCloseTogether) {
  Random random(5);
  int right = 0, wrong = 0;
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<Vec3> points;
    const auto bent = [](double x, double y, double z) { return Vec3{x, y, z + 0.12 * x * x}; };
    for (int i = -2; i <= 2; ++i)
      for (int j = -2; j <= 2; ++j)
        for (const double z : {0.0, 1.0})
          points.push_back(bent(i + random.uniform(-0.3, 0.3) + (z > 0 ? 0.4 : 0),
                                j + random.uniform(-0.3, 0.3), z));
    std::swap(points[0], points[24]);  // in the middle of the lower wall
    const Vec3 p = points[0];
    std::sort(points.begin() + 1, points.end(), [&](const Vec3& a, const Vec3& b) {
      return squared_distance(a, p) < squared_distance(b, p);
    });
    points.resize(21);
    std::vector<char> scratch;
    const Sheet sheet = find_own_sheet(points, 1, sheet_tolerances(0), scratch);
    ASSERT_TRUE(sheet.fitted());
    const Vec3 truth = normalized(Vec3{-0.24 * p.x, 0, 1});
    const bool good = axial_angle(normal_at(sheet, p), truth) < radians(4);
    right += good;
    wrong += !good;
  }
  EXPECT_GE(right, 95) << wrong << " of 100 lean";
}

// A flat sampled exactly, an edge of 165 degrees, a point of the flat close to it.
TEST(OwnSheet, BeyondAnObtuseEdgeNothingBendsAFlat) {
  std::vector<Vec3> points;
  const double slope = std::tan(radians(15));
  for (int i = -6; i <= 6; ++i)
    for (int j = -6; j <= 6; ++j) {
      const double x = i + 0.5, y = j + 0.31 * i;
      points.push_back({x, y, x > 0 ? slope * x : 0});
    }
  const OrderedCloud ordered = order_cloud(points);
  const KdTree tree(ordered);
  const Neighborhoods near = find_neighborhoods(tree, 20);
  const Spacing spacing = estimate_spacing(ordered.points, near);
  const std::vector<Sheet> own =
      find_own_sheets(ordered.points, near, spacing, sheet_tolerances(0));
  for (std::size_t i = 0; i < own.size(); ++i) {
    const Vec3 p = ordered.points[i] + ordered.origin;
    if (std::abs(p.x) > 3 || std::abs(p.y) > 3) continue;
    const Vec3 truth = p.x > 0 ? normalized(Vec3{-slope, 0, 1}) : Vec3{0, 0, 1};
    EXPECT_LT(axial_angle(normal_at(own[i], ordered.points[i]), truth), radians(0.1)) << p.x;
  }
}

// Where a tenth of a cloud is exact to rounding, what scatters elsewhere is structure, not noise.
TEST(NoiseLevels, AConstructedCloudHasNone) {
  std::vector<double> local(100, 0.09);
  EXPECT_EQ(noise_levels(local, 0.09).size(), 1u);
  std::fill_n(local.begin(), 40, 0.02);
  EXPECT_GT(noise_levels(local, 0.03).size(), 1u);
  std::fill_n(local.begin(), 40, 1e-9);
  EXPECT_EQ(noise_levels(local, 0.0), std::vector<double>{0.0});
}

std::vector<double> levels_of(const SynthOptions& options) {
  const PreparedCloud p = prepare_cloud(make_cloud(options).cloud.points, 40);
  const std::vector<Sheet> own =
      find_own_sheets(p.cloud.points, p.neighborhoods, p.spacing, sheet_tolerances(p.noise));
  return noise_levels(estimate_local_noise({p.cloud.points, p.neighborhoods, p.spacing, own}),
                      p.noise);
}

// Both sheets of an acute edge lie in the neighborhoods beside it: that is no noise. What a scanner
// does over half a part is.
TEST(NoiseLevels, AnAcuteEdgeMakesNone) {
  SynthOptions options{.shape = "wedge", .sampling = Sampling::random, .noise = 0.1};
  options.angle = radians(25);
  for (const std::uint64_t seed : {6u, 7u}) {
    options.seed = seed;
    EXPECT_EQ(levels_of(options).size(), 1u);
  }
  options.shape = "box", options.noise_gradient = 10;
  EXPECT_GT(levels_of(options).size(), 1u);
}

}  // namespace
}  // namespace spigolo
