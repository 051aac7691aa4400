// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
#include "spigolo/sheets/shares.h"

#include <gtest/gtest.h>

namespace spigolo {
namespace {

Sheet plane(const Vec3& n) {
  Sheet s;
  s.n = n, s.u = any_perpendicular(n), s.v = cross(s.n, s.u);
  s.support = 9;
  return s;
}

// Two quarter planes that end at the y axis: z = 0 where x < 0, x = 0 where z < 0.
LocalSheets edge() {
  LocalSheets sheets;
  sheets.count = 2;
  sheets.sheet[0] = plane({0, 0, 1}), sheets.sheet[1] = plane({1, 0, 0});
  sheets.share_above[0][1] = sheets.share_above[1][0] = 0;
  return sheets;
}

TEST(Shares, SumToOneAndAreEvenOnTheCrease) {
  const auto share = shares_of(edge(), {0, 3, 0}, 0.3);
  EXPECT_NEAR(share[0], 0.5, 1e-12);
  EXPECT_NEAR(share[0] + share[1], 1, 1e-12);
}

TEST(Shares, FarFromTheCreaseOneSheetHasAll) {
  EXPECT_NEAR(shares_of(edge(), {-5, 0, 0.2}, 0.3)[0], 1, 1e-9);
  EXPECT_NEAR(shares_of(edge(), {0.2, 0, -5}, 0.3)[1], 1, 1e-9);
}

TEST(Shares, BeyondTheEndOfASheetItIsLessLikely) {
  // as far from one plane as from the other, but where only the first has data
  const auto share = shares_of(edge(), {-0.3, 0, 0.3}, 0.3);
  EXPECT_GT(share[0], 0.7);
  // the same place, if both sheets went on
  LocalSheets crossing = edge();
  crossing.share_above[0][1] = crossing.share_above[1][0] = 0.5F;
  EXPECT_NEAR(shares_of(crossing, {-0.3, 0, 0.3}, 0.3)[0], 0.5, 1e-12);
}

TEST(Shares, AStrayBelongsToNone) {
  const auto share = shares_of(edge(), {3, 0, 3}, 0.3);
  EXPECT_EQ(share[0] + share[1], 0);
}

}  // namespace
}  // namespace spigolo
