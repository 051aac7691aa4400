// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// trace/open_air: no curve where there is no surface
#include "spigolo/trace/open_air.h"

#include <gtest/gtest.h>

#include <cmath>

namespace spigolo::test {
namespace {

// A sheet around the x axis, a point each spacing, but for a gap.
std::vector<Vec3> sheet(double gap_from, double gap_to) {
  std::vector<Vec3> points;
  for (double x = 0; x <= 30; ++x)
    for (double y = -3; y <= 3; ++y)
      if (x <= gap_from || x >= gap_to) points.push_back({x, y + 0.25, 0});
  return points;
}

RawNetwork along_x(bool corner) {
  RawNetwork network;
  RawCurve curve;
  for (double x = corner ? 1 : 0; x <= 30; ++x) curve.chain.places.push_back({x, 0, 0});
  if (corner) {
    network.junctions.push_back({0, 0, 0});
    curve.junction[0] = 0;
    network.curves.push_back(curve);  // two more, so that it is a corner
    for (Vec3& p : network.curves[0].chain.places) p = {p.x * 0.3, p.x * 0.2, 0};
    network.curves.push_back(curve);
    for (Vec3& p : network.curves[1].chain.places) p = {p.x * 0.3, -p.x * 0.2, 0};
  }
  network.curves.push_back(curve);
  return network;
}

TEST(OpenAir, CurvesEndWherePointsEnd) {
  const Survey survey(sheet(10, 16), CreaseSamples{}, 0, {});
  RawNetwork network = along_x(false);
  cut_open_air(network, survey, 0);
  ASSERT_EQ(network.curves.size(), 2U);
  EXPECT_NEAR(network.curves[0].chain.places.back().x, 10.75, 0.5);
  EXPECT_NEAR(network.curves[1].chain.places.front().x, 15.25, 0.5);
  EXPECT_EQ(network.curves[1].chain.places.back().x, 30);
}

TEST(OpenAir, GapsBetweenSamplesAreNone) {
  const Survey survey(sheet(10, 13), CreaseSamples{}, 0, {});
  RawNetwork network = along_x(false);
  cut_open_air(network, survey, 0);
  ASSERT_EQ(network.curves.size(), 1U);
  EXPECT_EQ(network.curves[0].chain.places.size(), 31U);
}

// It leaves its samples at a bend and comes back to them where it left.
TEST(OpenAir, AGuideThatSwingsOutHasCrossedNothing) {
  const Survey survey(sheet(10, 10), CreaseSamples{}, 0, {});
  RawNetwork network = along_x(false);
  auto& places = network.curves[0].chain.places;
  places.insert(places.begin() + 15, {{14, 0, 1}, {14.5, 0, 3}, {15, 0, 1}});
  cut_open_air(network, survey, 0);
  ASSERT_EQ(network.curves.size(), 1U);
  EXPECT_EQ(network.curves[0].chain.places.size(), 34U);
}

TEST(OpenAir, TheEndWithACornerKeepsIt) {
  const Survey survey(sheet(10, 16), CreaseSamples{}, 0, {});
  RawNetwork network = along_x(true);
  cut_open_air(network, survey, 0);
  int ends = 0;
  for (const RawCurve& curve : network.curves)
    for (const int j : curve.junction) ends += j != no_junction;
  EXPECT_EQ(network.junctions.size(), 1U);
  EXPECT_EQ(ends, 3);
}

// The mouth of a narrow slot, with corners on both sides that cut the chain across it.
TEST(OpenAir, APieceFromWallToWallGoes) {
  for (const bool open : {true, false}) {
    const Survey survey(sheet(10, open ? 12 : 10), CreaseSamples{}, 0, {});
    RawNetwork network;
    network.junctions = {{10, 0, 0}, {12, 0, 0}};
    RawCurve first, piece, last;
    for (double x = 0; x < 10; ++x) first.chain.places.push_back({x, 0, 0});
    for (double x = 13; x < 30; ++x) last.chain.places.push_back({x, 0, 0});
    piece.chain.places.push_back({11, 0, 0});
    first.junction[1] = piece.junction[0] = 0;
    piece.junction[1] = last.junction[0] = 1;
    first.cut = piece.cut = last.cut = true;
    network.curves = {first, piece, last};
    cut_open_air(network, survey, 0);
    EXPECT_EQ(network.curves.size(), open ? 2U : 3U);
  }
}

// The mouth of a hole that opens into a slot: three quarters of a circle.
TEST(OpenAir, AClosedRimOpensWhereTheSlotIs) {
  constexpr double radius = 3;
  std::vector<Vec3> points;
  std::vector<CreaseSample> samples;
  CurveDraft draft;
  draft.guide.closed = true;
  const auto at = [](double a) { return Vec3{radius * std::cos(a), radius * std::sin(a), 0}; };
  for (int i = 0; i <= 48; ++i) draft.guide.places.push_back(at(2 * pi * (i % 48) / 48));
  measure(draft.guide);
  draft.form = CircleFit{{}, {0, 0, 1}, radius, 0};
  for (int i = 0; i < 18; ++i) {
    const double a = 2 * pi * i / 18;
    if (a > 1 && a < 1 + half_pi) continue;
    for (double depth = 0; depth < 4; ++depth) points.push_back(at(a) - Vec3{0, 0, depth});
    for (double wide = 1; wide < 4; ++wide) points.push_back(at(a) * (1 + wide / radius));
    draft.members.push_back({a * radius, static_cast<std::uint32_t>(samples.size())});
    samples.push_back({at(a), {-std::sin(a), std::cos(a), 0}, half_pi});
  }
  std::vector<CurveDraft> drafts{draft};
  cut_open_air(drafts, Survey(points, CreaseSamples{}, 0, {}), samples, 3);
  ASSERT_EQ(drafts.size(), 1U);
  EXPECT_FALSE(drafts[0].guide.closed);
  EXPECT_EQ(drafts[0].members.size(), samples.size());
  EXPECT_NEAR(drafts[0].guide.length(), 1.5 * pi * radius, 1.5);
  EXPECT_EQ(finish(drafts[0], {}, samples, {}).shape, CurveShape::arc);
}

}  // namespace
}  // namespace spigolo::test
