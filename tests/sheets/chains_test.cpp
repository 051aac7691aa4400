// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/sheets/chains_test.cpp - what is too short for an edge, and where creases make a corner
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "spigolo/index/prepared_cloud.h"
#include "spigolo/sheets/chains.h"
#include "spigolo/sheets/joints.h"

namespace spigolo {
namespace {

// A lattice of 16 x 16 points, slightly bent so that it has a canonical frame of its own.
PreparedCloud lattice() {
  std::vector<Vec3> points;
  for (int x = 0; x < 16; ++x)
    for (int y = 0; y < 16; ++y)
      points.push_back({double(x), double(y), 1e-3 * std::sin(x + 2.0 * y)});
  return prepare_cloud(points, 48);
}

std::uint32_t point_at(const PreparedCloud& p, int x, int y) {
  return p.cloud.rank[static_cast<std::size_t>(16 * x + y)];
}

SheetVerdict edge(const Vec3& at, const Vec3& direction) {
  SheetVerdict verdict;
  verdict.kind = PointKind::edge;
  verdict.crease_point = at;
  verdict.direction = normalized(direction);
  verdict.deviation = 1;
  return verdict;
}

std::size_t marks(const VerdictRows& verdicts, PointKind kind) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < verdicts.size(); ++i) n += verdicts[i].kind == kind;
  return n;
}

TEST(Chains, NoiseLeavesRowsAndDropsClumps) {
  const PreparedCloud p = lattice();
  VerdictRows verdicts(p.cloud.size());
  for (int x = 0; x < 6; ++x) {
    const std::uint32_t i = point_at(p, x, 3);
    verdicts.set(i, edge(p.cloud.points[i], {1, 0, 0}));
  }
  for (const auto& [x, y] : {std::pair{11, 11}, {12, 11}, {11, 12}, {12, 12}}) {
    const std::uint32_t i = point_at(p, x, y);
    verdicts.set(i, edge(p.cloud.points[i], {1, 0, 0}));
  }
  VerdictRows quiet = verdicts;
  drop_short_chains(p.cloud.points, p.neighborhoods, p.spacing, 0.05, quiet);
  EXPECT_EQ(marks(quiet, PointKind::edge), 10u);
  drop_short_chains(p.cloud.points, p.neighborhoods, p.spacing, 0.3, verdicts);
  EXPECT_EQ(marks(verdicts, PointKind::edge), 6u);
  EXPECT_EQ(verdicts[point_at(p, 0, 3)].kind, PointKind::edge);
}

// Three rows of marks that run from (8, 8); the creases meet in a point 0.3 above it.
VerdictRows star(const PreparedCloud& p, const std::array<Vec3, 3>& directions) {
  VerdictRows verdicts(p.cloud.size());
  const Vec3 meet = p.cloud.points[point_at(p, 8, 8)] + Vec3{0, 0, 0.3};
  for (int t = 1; t < 4; ++t) {
    verdicts.set(point_at(p, 8 + t, 8), edge(meet + directions[0] * t, directions[0]));
    verdicts.set(point_at(p, 8, 8 + t), edge(meet + directions[1] * t, directions[1]));
    verdicts.set(point_at(p, 8 - t, 8 - t + 1), edge(meet + directions[2] * t, directions[2]));
  }
  return verdicts;
}

TEST(Joints, CreasesOfThreeDirectionsMakeACornerWhereTheyMeet) {
  const PreparedCloud p = lattice();
  auto verdicts = star(p, {Vec3{1, 0, -1}, Vec3{0, 1, -1}, Vec3{-1, -1, -1}});
  join_creases(p.cloud.points, p.neighborhoods, p.spacing, verdicts);
  const std::uint32_t center = point_at(p, 8, 8);
  ASSERT_EQ(verdicts[center].kind, PointKind::corner);
  EXPECT_LT(distance(verdicts[center].crease_point, p.cloud.points[center] + Vec3{0, 0, 0.3}),
            1e-9);
  EXPECT_EQ(verdicts[center].sheets, 3);
  EXPECT_EQ(marks(verdicts, PointKind::corner), 1u);
}

TEST(Joints, CreasesOfOnePlaneAreNoCorner) {
  const PreparedCloud p = lattice();
  auto verdicts = star(p, {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{-1, -1, 0}});
  join_creases(p.cloud.points, p.neighborhoods, p.spacing, verdicts);
  EXPECT_EQ(marks(verdicts, PointKind::corner), 0u);
}

}  // namespace
}  // namespace spigolo
