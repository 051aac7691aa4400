// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
#include "spigolo/sheets/agree.h"

#include <gtest/gtest.h>

#include <cmath>

#include "spigolo/index/kd_tree.h"

namespace spigolo {
namespace {

// Both rims of a wall 2.2 spacings thick, more of the lower one heard: every sample of the upper
// one is told its own.
TEST(Agree, OfTwoRimsTheNearerOneCounts) {
  std::vector<Vec3> points;
  for (int i = -4; i <= 4; ++i) points.push_back({0.9 * i, 0, 0});
  for (int i = -12; i <= 12; ++i) points.push_back({0.3 * i, 0.01, -2.2});
  const OrderedCloud ordered = order_cloud(points);
  const Neighborhoods near = find_neighborhoods(KdTree(ordered), 33);
  Spacing spacing;
  spacing.of_point.assign(ordered.size(), 1);
  VerdictRows proposals(ordered.size());
  for (std::size_t i = 0; i < ordered.size(); ++i) {
    SheetVerdict edge;
    edge.kind = PointKind::edge;
    edge.crease_point = ordered.points[i];
    edge.direction = {1, 0, 0};
    edge.into = {Vec3{0, 1, 0}, Vec3{0, 0, -1}};
    proposals.set(i, edge);
  }
  const VerdictRows agreed = agree_on_creases(ordered.points, near, spacing, proposals);
  for (std::size_t i = 0; i < ordered.size(); ++i) {
    if (std::abs(ordered.points[i].x) > 1.5) continue;  // too few votes towards the ends
    ASSERT_EQ(agreed[i].kind, PointKind::edge);
    EXPECT_LT(distance(agreed[i].crease_point, ordered.points[i]), 0.1) << i;
  }
}

}  // namespace
}  // namespace spigolo
