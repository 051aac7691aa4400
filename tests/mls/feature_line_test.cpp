// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
#include "spigolo/mls/feature_line.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "spigolo/core/random.h"

namespace spigolo {
namespace {

TEST(FeatureLine, StraightEdgesAreReproduced) {
  Random random(91);
  for (int trial = 0; trial < 50; ++trial) {
    const Vec3 at = random.in_ball() * 10.0, along = random.on_sphere();
    std::vector<Vec3> f;
    const std::size_t n = 4 + random.below(5);
    for (std::size_t i = 0; i < n; ++i) f.push_back(at + along * random.uniform(-3, 3));
    const auto line = make_feature_line(f);
    ASSERT_TRUE(line);
    for (int i = 0; i <= 20; ++i) {
      const Vec3 d = point_at(*line, i / 20.0) - at;
      EXPECT_LT(norm(d - along * dot(d, along)), 1e-12);
    }
  }
}

TEST(FeatureLine, FourPointsAreTheControlPointsInOrder) {
  const std::vector<Vec3> in_order = {{0, 0, 0}, {1, 0.2, 0}, {2, 0.2, 0}, {3, 0, 0}};
  std::vector<Vec3> f = {in_order[2], in_order[0], in_order[3], in_order[1]};
  const auto line = make_feature_line(f);
  ASSERT_TRUE(line);
  const bool forward = line->b[0] == in_order[0];
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(line->b[forward ? i : 3 - i], in_order[i]);
}

TEST(FeatureLine, AnEmptySectorTakesFromTheOther) {
  std::vector<Vec3> f = {{0, 0, 0}, {4.1, 0.1, 0}, {4.4, 0.2, 0}, {4.7, 0.1, 0}, {5, 0, 0}};
  const auto line = make_feature_line(f);
  ASSERT_TRUE(line);
  for (const Vec3& b : line->b) EXPECT_TRUE(is_finite(b));
}

TEST(FeatureLine, TooFewOrEqualPointsMakeNone) {
  std::vector<Vec3> three = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, same(6, Vec3{1, 2, 3});
  EXPECT_FALSE(make_feature_line(three));
  EXPECT_FALSE(make_feature_line(same));
}

TEST(FeatureLine, FootIsTheNearestPoint) {
  Random random(92);
  for (int trial = 0; trial < 100; ++trial) {
    FeatureLine line;  // nearly straight, as within a neighborhood
    for (std::size_t i = 0; i < 4; ++i)
      line.b[i] = Vec3{static_cast<double>(i), 0, 0} + random.in_ball() * 0.4;
    const LineFoot foot(line);
    for (int i = 0; i < 20; ++i) {
      const Vec3 p = Vec3{1.5, 0, 0} + random.in_ball() * 3.0;
      double nearest = infinity;
      for (int t = 0; t <= 5000; ++t)
        nearest = std::min(nearest, distance(p, point_at(line, t / 5000.0)));
      EXPECT_LT(distance(p, foot.nearest(p)), nearest + 1e-3);
    }
  }
}

}  // namespace
}  // namespace spigolo
