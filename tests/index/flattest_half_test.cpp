// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
#include "spigolo/index/flattest_half.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "spigolo/core/random.h"

namespace spigolo {
namespace {

// Plane after plane, as the header says it.
double one_by_one(const std::array<Vec3, half_of>& e) {
  double least = infinity;
  for (std::size_t a = 0; a < half_of; ++a)
    for (std::size_t b = a + 1; b < half_of; ++b) {
      const Vec3 n = cross(e[a], e[b]);
      if (norm(n) < 0.3 * norm(e[a]) * norm(e[b]) || norm(n) == 0) continue;
      std::array<double, half_of> off;
      for (std::size_t t = 0; t < half_of; ++t) off[t] = std::abs(dot(normalized(n), e[t]));
      std::nth_element(off.begin(), off.begin() + half_of / 2, off.end());
      least = std::min(least, off[half_of / 2]);
    }
  return least;
}

TEST(FlattestHalf, SameAsPlaneAfterPlane) {
  Random random(8);
  for (int trial = 0; trial < 200; ++trial) {
    std::array<Vec3, half_of> around;
    for (Vec3& p : around) p = {random.normal(), random.normal(), 0.1 * random.normal()};
    EXPECT_EQ(flattest_half(around), one_by_one(around));
  }
}

TEST(FlattestHalf, HalfOfARightAngleIsFlat) {
  Random random(9);
  std::array<Vec3, half_of> around;
  for (std::size_t t = 0; t < half_of; ++t) {
    const double x = random.uniform(-1, 1), y = random.uniform(0.1, 1);
    around[t] = t < 9 ? Vec3{x, y, 0} : Vec3{x, 0, y};
  }
  EXPECT_LT(flattest_half(around), 1e-15);
}

TEST(FlattestHalf, PointsOnALineHaveNone) {
  std::array<Vec3, half_of> around;
  for (std::size_t t = 0; t < half_of; ++t) around[t] = {static_cast<double>(t + 1), 0, 0};
  EXPECT_EQ(flattest_half(around), infinity);
}

}  // namespace
}  // namespace spigolo
