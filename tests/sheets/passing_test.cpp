// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
#include "spigolo/sheets/passing.h"

#include <gtest/gtest.h>

#include "spigolo/core/random.h"

namespace spigolo {
namespace {

// The crease is the z axis, one sheet the half plane x > 0, the other turned from it by `angle`.
SheetVerdict wedge(double angle) {
  SheetVerdict edge;
  edge.kind = PointKind::edge;
  edge.direction = {0, 0, 1};
  edge.into = {Vec3{1, 0, 0}, Vec3{std::cos(angle), std::sin(angle), 0}};
  return edge;
}

constexpr double near = 0.6, noise = 0.4;

// Flat: the place is normally distributed along x, whatever the height of the sample.
TEST(Passing, ClosedFormOnAFlatPair) {
  for (const double x : {0.0, 0.5, 1.0, 3.0})
    for (const double y : {-1.0, 0.0, 0.3}) {
      const double expected = 0.5 * (std::erf((near - x) / (noise * std::sqrt(2.0))) +
                                     std::erf((near + x) / (noise * std::sqrt(2.0))));
      EXPECT_NEAR(passing_probability(wedge(pi), {x, y, 7}, 1, {near}, noise), expected, 1e-12);
    }
}

TEST(Passing, WithoutNoiseItIsTheDistance) {
  EXPECT_NEAR(passing_probability(wedge(pi / 2), {0.5, 0, 0}, 1, {near}, 1e-3), 1, 1e-12);
  EXPECT_NEAR(passing_probability(wedge(pi / 2), {0.7, 0, 0}, 1, {near}, 1e-3), 0, 1e-12);
  EXPECT_EQ(passing_probability(wedge(pi / 2), {-0.4, -0.4, 0}, 1, {near}, 1e-3), 1);
  EXPECT_EQ(passing_probability(wedge(pi / 2), {-0.7, -0.7, 0}, 1, {near}, 1e-3), 0);
}

// Samples of a right angle, shaken: of those said to pass with some probability, that share does.
TEST(Passing, IsTheShareThatPasses) {
  Random random(91);
  const SheetVerdict edge = wedge(pi / 2);
  double said = 0, true_share = 0;
  int n = 0;
  for (int i = 0; i < 200000; ++i) {
    const double t = random.uniform(0, 6);
    const Vec3 place = i % 2 ? Vec3{t, 0, 0} : Vec3{0, t, 0};
    const Vec3 sample = place + noise * Vec3{random.normal(), random.normal(), random.normal()};
    const double p = passing_probability(edge, sample, 1, {near}, noise);
    if (p < 0.3 || p > 0.4) continue;
    said += p, true_share += t < near, ++n;
  }
  ASSERT_GT(n, 1000);
  EXPECT_NEAR(said / n, true_share / n, 0.03);
}

TEST(Passing, ScalesWithTheCloud) {
  const double one = passing_probability(wedge(2), {0.5, 0.2, 0}, 1, {near}, noise);
  EXPECT_NEAR(passing_probability(wedge(2), {0.005, 0.002, 0}, 0.01, {near}, noise), one, 1e-12);
}

// Places of a right angle: anywhere, or a row on the crease and rows a spacing apart.
Vec3 shaken(Random& random, double t, bool first, double by) {
  const Vec3 place = first ? Vec3{t, 0, 0} : Vec3{0, t, 0};
  return place + by * Vec3{random.normal(), random.normal(), random.normal()};
}

TEST(Passing, RowsOnCreasesShow) {
  Random random(17);
  const SheetVerdict edge = wedge(pi / 2);
  for (const double by : {0.1, 0.2, 0.3}) {
    double anywhere = 0, in_rows = 0;
    for (int i = 0; i < 20000; ++i) {
      const bool first = i % 2 == 0;
      anywhere += placed_evidence(edge, shaken(random, random.uniform(0, 6), first, by), 1, by);
      // One sample in eleven is of the row that both sheets share.
      const double t = i % 11 == 0 ? 0 : 1 + static_cast<double>(random.below(5));
      in_rows += placed_evidence(edge, shaken(random, t, first, by), 1, by);
    }
    EXPECT_LT(anywhere, -0.001 * 20000) << by;
    EXPECT_GT(in_rows, 0.01 * 20000) << by;
  }
}

TEST(Passing, WithRowsItIsTheShareOfTheRow) {
  Random random(23);
  const SheetVerdict edge = wedge(pi / 2);
  double said = 0, of_row = 0;
  int n = 0;
  for (int i = 0; i < 400000; ++i) {
    const double t = i % 11 == 0 ? 0 : 1 + static_cast<double>(random.below(5));
    const Vec3 sample = shaken(random, t, i % 2 == 0, 0.3);
    const double p = passing_probability(edge, sample, 1, {near, true}, 0.3);
    if (p < 0.4 || p > 0.6) continue;
    said += p, of_row += t == 0, ++n;
  }
  ASSERT_GT(n, 1000);
  EXPECT_NEAR(said / n, of_row / n, 0.1);  // it does not count on a second row
}

}  // namespace
}  // namespace spigolo
