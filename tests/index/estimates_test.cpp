// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "spigolo/index/kd_tree.h"
#include "spigolo/index/neighborhoods.h"
#include "spigolo/index/noise.h"
#include "spigolo/index/spacing.h"
#include "support/clouds.h"

namespace spigolo {
namespace {

struct Estimates {
  double spacing, noise;
};

Estimates estimate(const std::vector<Vec3>& points) {
  const OrderedCloud cloud = order_cloud(points);
  const KdTree tree(cloud);
  const Neighborhoods neighborhoods = find_neighborhoods(tree, 20);
  const Spacing spacing = estimate_spacing(cloud.points, neighborhoods);
  return {spacing.of_cloud, estimate_noise(cloud.points, neighborhoods, spacing, tree)};
}

std::vector<Vec3> shaken(std::vector<Vec3> points, double sigma, std::uint64_t seed) {
  Random random(seed);
  for (Vec3& p : points) p += sigma * Vec3{random.normal(), random.normal(), random.normal()};
  return points;
}

// 1 / sqrt(density) = 1 for every one of these.
TEST(Spacing, OneDensityOneSpacing) {
  const auto lattice = test::square_lattice(100);
  auto random = test::random_square(10000, 21);
  for (Vec3& p : random) p *= 100.0;
  std::vector<Vec3> scan_lines;  // four times denser along than across
  for (int i = 0; i < 50; ++i)
    for (int j = 0; j < 200; ++j) scan_lines.push_back({i * 2.0, j * 0.5, 0});
  EXPECT_NEAR(estimate(lattice).spacing, 1.0, 0.02);
  EXPECT_NEAR(estimate(random).spacing, 1.0, 0.05);
  EXPECT_NEAR(estimate(scan_lines).spacing, 1.0, 0.08);
  EXPECT_NEAR(estimate(test::repeated(lattice)).spacing, 1.0, 0.02);
}

TEST(Spacing, ScalesWithTheCloud) {
  auto points = test::random_sphere(4000, 22);
  const double one = estimate(points).spacing;
  for (Vec3& p : points) p *= 1e-4;
  EXPECT_NEAR(estimate(points).spacing, one * 1e-4, one * 1e-13);
}

TEST(Noise, ZeroOnPlanesAndNearlySoOnSpheres) {
  EXPECT_LT(estimate(test::square_lattice(100)).noise, 1e-9);
  EXPECT_LT(estimate(test::random_square(10000, 23)).noise, 1e-9);
  EXPECT_LT(estimate(test::random_sphere(5000, 24)).noise, 0.01);  // radius 20 spacings
}

TEST(Noise, MeasuresGaussianNoiseWithinATenth) {
  for (const double sigma : {0.05, 0.1, 0.25, 0.5, 0.75, 1.0}) {
    auto random = test::random_square(10000, 25);
    for (Vec3& p : random) p *= 100.0;
    for (const auto& points : {test::square_lattice(100), random}) {
      const Estimates e = estimate(shaken(points, sigma, 26));
      EXPECT_NEAR(e.noise * e.spacing, sigma, 0.1 * sigma) << sigma;
    }
  }
}

// Two walls closer than the neighborhoods are wide: what lies on the other one is no noise.
TEST(Noise, ThinWallsAreNotNoise) {
  for (const double thickness : {1.2, 1.5, 2.5}) {
    auto points = test::random_square(5000, 27);
    for (Vec3& p : points) p *= std::sqrt(5000);
    const auto other = test::moved(points, {0.3, 0.4, thickness});
    points.insert(points.end(), other.begin(), other.end());
    EXPECT_LT(estimate(points).noise, 1e-9) << thickness;
  }
}

// Even samples, shaken across the surface only: small neighborhoods are balls of points by then,
// and find too much; a wide look does not.
TEST(Noise, LargeNoiseOfEvenSamplesIsMeasuredByWideLooks) {
  for (const double sigma : {0.7, 1.0, 1.4}) {
    Random random(28);
    std::vector<Vec3> points;
    for (int x = 0; x < 70; ++x)
      for (int y = 0; y < 70; ++y)
        points.push_back({x + random.uniform(-0.2, 0.2), y + random.uniform(-0.2, 0.2),
                          sigma * random.normal()});
    const Estimates e = estimate(points);
    EXPECT_NEAR(e.noise, sigma / e.spacing, 0.15 * sigma / e.spacing);
  }
}

TEST(Estimates, TinyCloudsGiveZeroNotNonsense) {
  for (const auto& [name, points] : test::hard_clouds()) {
    const Estimates e = estimate(points);
    EXPECT_TRUE(e.spacing >= 0 && std::isfinite(e.spacing)) << name;
    EXPECT_TRUE(e.noise >= 0 && std::isfinite(e.noise)) << name;
  }
}

}  // namespace
}  // namespace spigolo
