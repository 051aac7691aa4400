// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/index/order_test.cpp - the canonical order, sorted in blocks, beside a plain sort
#include "spigolo/index/order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "spigolo/core/error.h"
#include "spigolo/index/noise.h"
#include "spigolo/index/radix_sort.h"
#include "spigolo/index/spacing.h"
#include "support/clouds.h"

namespace spigolo {
namespace {

std::vector<CodeKey> random_keys(std::size_t n, std::uint64_t mask, std::uint64_t seed) {
  Random random(seed);
  std::vector<CodeKey> keys;
  for (std::uint32_t i = 0; i < n; ++i) {
    const auto high = static_cast<std::uint64_t>(random.uniform() * 2147483648.0);
    const auto low = static_cast<std::uint64_t>(random.uniform() * 4294967296.0);
    keys.push_back({(high << 32 | low) & mask, i});
  }
  return keys;
}

TEST(RadixSort, IsAStableSort) {
  for (const std::uint64_t mask : {~std::uint64_t{0} >> 1, std::uint64_t{0xff00ff}}) {
    for (const std::size_t n : {0u, 1u, 1000u, 200000u}) {
      std::vector<CodeKey> keys = random_keys(n, mask, 5), expected = keys;
      std::stable_sort(expected.begin(), expected.end(),
                       [](const CodeKey& a, const CodeKey& b) { return a.code < b.code; });
      radix_sort(keys, 0, 6);
      for (std::size_t i = 0; i < n; ++i) ASSERT_EQ(keys[i].index, expected[i].index);
    }
  }
}

// Codes ascend, copies share a place, points of one cell ascend by coordinates: all there is to
// the order, so nothing else can be meant by it.
void expect_canonical(const std::vector<Vec3>& points) {
  const OrderedCloud cloud = order_cloud(points);
  validate(cloud);
  for (std::size_t i = 1; i < cloud.size(); ++i) {
    if (cloud.codes[i] != cloud.codes[i - 1]) continue;
    const Vec3 &a = cloud.points[i - 1], &b = cloud.points[i];
    ASSERT_LE(std::tuple(a.x, a.y, a.z), std::tuple(b.x, b.y, b.z));
  }
  for (std::size_t i = 0; i < points.size(); ++i)
    ASSERT_TRUE(cloud.points[cloud.rank[i]] == points[i] - cloud.origin);
  Job two;
  two.threads = 2;
  const OrderedCloud again = order_cloud(points, two);
  EXPECT_TRUE(again.points == cloud.points && again.rank == cloud.rank &&
              again.codes == cloud.codes);
  std::vector<Vec3> turned(points.rbegin(), points.rend());
  EXPECT_TRUE(order_cloud(turned).points == cloud.points);
}

TEST(Order, ManyPoints) { expect_canonical(test::random_square(150000, 5)); }

TEST(Order, ClumpsFarFromEachOther) {  // alike in the upper half of their bits
  expect_canonical(test::clumps(5));
  std::vector<Vec3> points = test::random_square(50000, 6);
  for (Vec3& p : points) p = p * 1e-5;
  points.push_back({1, 1, 1});
  expect_canonical(points);
}

TEST(Order, CopiesAcrossRanges) {
  std::vector<Vec3> points = test::random_square(30000, 7);
  const std::vector<Vec3> once = points;
  for (int copy = 0; copy < 3; ++copy) points.insert(points.end(), once.begin(), once.end());
  expect_canonical(points);
  EXPECT_EQ(order_cloud(points).duplicates, 3 * once.size());
}

// A square and, at its lower corner, points nearer to each other than coordinates from its middle
// can tell.
std::vector<Vec3> square_with_clump(double step) {
  std::vector<Vec3> points = test::random_square(2000, 8);
  Random random(9);
  for (int i = 0; i < 200; ++i) points.push_back({i * step, random.uniform() * step, 0});
  return points;
}

TEST(Order, PlacesThatTheShiftMakesOneAreOne) {
  const std::vector<Vec3> points = square_with_clump(1e-20);
  const OrderedCloud cloud = order_cloud(points);
  validate(cloud);
  EXPECT_EQ(cloud.duplicates, 199u);
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_TRUE(cloud.points[cloud.rank[i]] == points[i] - cloud.origin);
}

TEST(Order, SizesWithoutPowersAreRefused) {
  for (const double scale : {1e-300, 1e-80, 1e80, 1e160, 1e308}) {
    std::vector<Vec3> points = test::random_square(200, 9);
    for (Vec3& p : points) p = p * scale;
    EXPECT_THROW(order_cloud(points), NoResultError) << scale;
  }
  EXPECT_THROW(order_cloud(std::vector<Vec3>{{-1.7e308, 0, 0}, {1.7e308, 0, 0}}), NoResultError);
  const std::vector<Vec3> one(3, Vec3{1e200, 0, 0});
  EXPECT_EQ(order_cloud(one).size(), 1u);
}

TEST(Spacing, ClumpsWithoutSquaresHaveOne) {
  std::vector<Vec3> points = square_with_clump(1e-170);
  for (std::size_t i = 0; i < 2000; ++i) points.push_back(-points[i]);  // keeps the origin at 0
  const OrderedCloud cloud = order_cloud(points);
  ASSERT_TRUE(cloud.origin == Vec3{});
  const KdTree tree(cloud);
  const Neighborhoods neighborhoods = find_neighborhoods(tree, 20);
  validate(neighborhoods, cloud.points);
  const Spacing spacing = estimate_spacing(cloud.points, neighborhoods);
  EXPECT_GT(*std::min_element(spacing.of_point.begin(), spacing.of_point.end()), 0);
  EXPECT_TRUE(std::isfinite(estimate_noise(cloud.points, neighborhoods, spacing, tree)));
}

TEST(Spacing, MedianIsTheMiddleOne) {
  for (const std::size_t n : {50u, 51u, 20000u}) {
    const OrderedCloud cloud = order_cloud(test::random_square(static_cast<int>(n), 5));
    const Spacing spacing = estimate_spacing(cloud.points, find_neighborhoods(KdTree(cloud), 12));
    std::vector<double> sorted = spacing.of_point;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(spacing.of_cloud, sorted[sorted.size() / 2]);
  }
}

}  // namespace
}  // namespace spigolo
