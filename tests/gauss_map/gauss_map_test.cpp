// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
#include "spigolo/gauss_map/gauss_map.h"

#include <gtest/gtest.h>

#include "spigolo/core/random.h"

namespace spigolo {
namespace {

std::vector<Vec3> random_neighbors(std::size_t k, Random& random) {
  std::vector<Vec3> neighbors;
  for (std::size_t i = 0; i < k; ++i) neighbors.push_back(random.in_ball());
  return neighbors;
}

TEST(GaussMap, HoldsTheNormalOfEveryTriangle) {
  Random random(41);
  GaussMap map;
  for (const std::size_t k : {2u, 3u, 8u, 17u, 64u}) {
    const Vec3 p = random.in_ball();
    const std::vector<Vec3> neighbors = random_neighbors(k, random);
    compute_gauss_map(p, neighbors, map);
    std::size_t t = 0;
    for (std::size_t i = 0; i < k; ++i)
      for (std::size_t j = i + 1; j < k; ++j) {
        const Vec3 a = normalized(neighbors[i] - p), b = normalized(neighbors[j] - p);
        const Vec3 n = cross(a, b);
        if (norm(n) < degenerate_sine) continue;
        ASSERT_LT(t, map.size);
        EXPECT_LT(angle_between(map.normal(t), n), 2e-5);
        EXPECT_NEAR(norm(map.normal(t)), 1, 1e-6);
        ++t;
      }
    EXPECT_EQ(t, map.size);
  }
}

TEST(GaussMap, LeavesOutCoincidentAndCollinearNeighbors) {
  GaussMap map;
  compute_gauss_map({1, 1, 1}, std::vector<Vec3>{{1, 1, 1}, {2, 1, 1}, {3, 1, 1}, {0, 1, 1}}, map);
  EXPECT_EQ(map.size, 0u);
  compute_gauss_map({0, 0, 0}, std::vector<Vec3>{{1, 0, 0}, {2, 0, 0}, {0, 1, 0}}, map);
  EXPECT_EQ(map.size, 2u);
}

// Coordinates stored as floats, one thousandth of their size apart: collinear samples stay so.
TEST(GaussMap, RoundedLatticesHaveNoStrayNormals) {
  GaussMap map;
  std::vector<Vec3> neighbors;
  const auto rounded = [](double v) { return static_cast<double>(static_cast<float>(v)); };
  const Vec3 p{rounded(0.731), rounded(0.377), rounded(0.5)};
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j)
      if (i != 0 || j != 0)
        neighbors.push_back({rounded(0.731 + 0.001 * i), rounded(0.377 + 0.001 * j), rounded(0.5)});
  compute_gauss_map(p, neighbors, map);
  EXPECT_LT(normal_spread(map).spread, 1e-3);
}

TEST(GaussMap, SizesAndPlacesDoNotMatter) {
  Random random(42);
  const std::vector<Vec3> neighbors = random_neighbors(20, random);
  std::vector<Vec3> moved;
  const Vec3 offset{1024, -2048, 512};
  for (const Vec3& n : neighbors) moved.push_back((n + Vec3{0.5, 0.25, 0.125}) * 1024.0 + offset);
  GaussMap a, b;
  compute_gauss_map({0, 0, 0}, neighbors, a);
  compute_gauss_map(Vec3{0.5, 0.25, 0.125} * 1024.0 + offset, moved, b);
  ASSERT_EQ(a.size, b.size);
  for (std::size_t t = 0; t < a.size; ++t) EXPECT_LT(angle_between(a.normal(t), b.normal(t)), 1e-5);
}

TEST(NormalSpread, ClosedForms) {
  GaussMap map;
  const auto spread_of = [&](const std::vector<Vec3>& normals) {
    map.size = normals.size();
    map.x.clear(), map.y.clear(), map.z.clear();
    for (const Vec3& n : normals)
      map.x.push_back(static_cast<float>(n.x)), map.y.push_back(static_cast<float>(n.y)),
          map.z.push_back(static_cast<float>(n.z));
    return normal_spread(map);
  };
  EXPECT_NEAR(spread_of({{0, 0, 1}, {0, 0, -1}, {0, 0, 1}}).spread, 0, 1e-7);
  const double a = 0.3;  // two bundles at +-a around z: every normal is a from the axis
  const auto two = spread_of({{std::sin(a), 0, std::cos(a)}, {-std::sin(a), 0, std::cos(a)}});
  EXPECT_NEAR(two.spread, a, 1e-6);
  EXPECT_NEAR(std::abs(two.axis.z), 1, 1e-6);
  EXPECT_NEAR(spread_of({{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}).spread, std::asin(std::sqrt(2.0 / 3)),
              1e-6);
  EXPECT_EQ(normal_spread(GaussMap{}).spread, 0);
}

}  // namespace
}  // namespace spigolo
