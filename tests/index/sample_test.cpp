// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
#include "spigolo/index/sample.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "spigolo/core/random.h"

namespace spigolo {
namespace {

Spacing spacings(std::size_t n, double scatter, double unit = 1) {
  Random random(8);
  Spacing spacing;
  for (std::size_t i = 0; i < n; ++i)
    spacing.of_point.push_back(unit * (1 + random.uniform(0, scatter)));
  spacing.of_cloud = unit;
  return spacing;
}

TEST(Sample, AboutAsManyAsAskedAscendingEachOnce) {
  for (const double scatter : {0.0, 0.3})
    for (const std::size_t asked : {1000u, 5000u}) {
      const auto sample = sample_points(spacings(20000, scatter), asked);
      EXPECT_NEAR(static_cast<double>(sample.size()), static_cast<double>(asked),
                  0.2 * static_cast<double>(asked));
      EXPECT_TRUE(std::is_sorted(sample.begin(), sample.end()));
      EXPECT_EQ(std::adjacent_find(sample.begin(), sample.end()), sample.end());
      EXPECT_LT(sample.back(), 20000u);
    }
}

TEST(Sample, AllPointsWhereThereAreNoMore) {
  EXPECT_EQ(sample_points(spacings(50, 0.3), 50).size(), 50u);
  EXPECT_EQ(sample_points(spacings(50, 0.3), 500).size(), 50u);
  EXPECT_TRUE(sample_points({}, 10).empty());
}

TEST(Sample, TheSamePointsInAnotherOrderAndSize) {
  const Spacing spacing = spacings(20000, 0.3);
  Spacing backward = spacings(20000, 0.3, 1.0 / 3);
  std::reverse(backward.of_point.begin(), backward.of_point.end());
  const auto sample = sample_points(spacing, 3000);
  auto other = sample_points(backward, 3000);
  std::reverse(other.begin(), other.end());
  for (std::uint32_t& i : other) i = 19999 - i;
  std::vector<std::uint32_t> both;
  std::set_intersection(sample.begin(), sample.end(), other.begin(), other.end(),
                        std::back_inserter(both));
  EXPECT_GT(both.size(), sample.size() - 10);  // scaling rounds: a few may fall on the other side
}

}  // namespace
}  // namespace spigolo
