// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
#include "spigolo/sheets/verdict_rows.h"

#include <gtest/gtest.h>

namespace spigolo {
namespace {

SheetVerdict edge(double deviation) {
  SheetVerdict verdict;
  verdict.kind = PointKind::edge;
  verdict.deviation = deviation;
  return verdict;
}

TEST(VerdictRows, SurfaceWhereNothingIsSaid) {
  VerdictRows rows(4);
  rows.set(2, edge(1));
  EXPECT_EQ(rows.size(), 4u);
  for (const std::size_t i : {0u, 1u, 3u}) EXPECT_TRUE(rows[i].says_nothing());
  EXPECT_EQ(rows[2].deviation, 1);
  rows.set(2, {});
  EXPECT_TRUE(rows[2].says_nothing());
  rows.set(2, edge(2));
  EXPECT_EQ(rows[2].deviation, 2);
}

TEST(VerdictRows, ABendIsKept) {
  VerdictRows rows(2);
  SheetVerdict bend;
  bend.folded = -1;
  rows.set(1, bend);
  EXPECT_EQ(rows[1].kind, PointKind::surface);
  EXPECT_EQ(rows[1].folded, -1);
}

TEST(VerdictRows, AllThatWasFound) {
  const std::vector<FoundVerdict> found = {{3, edge(3)}, {0, edge(0.5)}};
  const VerdictRows rows(5, found);
  EXPECT_EQ(rows[3].deviation, 3);
  EXPECT_EQ(rows[0].deviation, 0.5);
  EXPECT_TRUE(rows[1].says_nothing());
}

TEST(VerdictRows, CopiesAreApart) {
  VerdictRows rows(3);
  rows.set(1, edge(1));
  VerdictRows other = rows;
  other.edit(1).deviation = 2;
  EXPECT_EQ(rows[1].deviation, 1);
  EXPECT_EQ(other[1].deviation, 2);
}

}  // namespace
}  // namespace spigolo
