// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// Pieces of surface too narrow for samples of their own: their two ends are edges.
#include <gtest/gtest.h>

#include <cmath>

#include "spigolo/detect/detect.h"
#include "spigolo/measure/classification.h"
#include "spigolo/synth/synth.h"

namespace spigolo {
namespace {

// Rows of samples along y: `across` steps from `start` in direction `step`, each 21 long.
void add_rows(std::vector<Vec3>& points, const Vec3& start, const Vec3& step, int across,
              double shift) {
  for (int i = 0; i < across; ++i)
    for (int j = -10; j <= 10; ++j)
      points.push_back(start + step * i + Vec3{0, j + shift + 0.37 * i, 0});
}

// Away from the borders: row 0 is marked if `first`, all others are not.
void expect_first_row_only(const Features& f, const std::vector<Vec3>& points, std::size_t begin,
                           int across) {
  for (std::size_t i = begin; i < begin + static_cast<std::size_t>(across) * 21; ++i) {
    if (std::abs(points[i].y) > 6 || (i - begin) / 21 + 3 > static_cast<std::size_t>(across))
      continue;
    const bool first = (i - begin) / 21 == 0;
    EXPECT_EQ(f.kind[i], first ? PointKind::edge : PointKind::surface)
        << points[i].x << " " << points[i].y;
  }
}

TEST(Narrow, BothEndsOfAStepWithoutSamplesOnItsWallAreEdges) {
  std::vector<Vec3> points;
  add_rows(points, {0, 0, 0}, {-1, 0, 0}, 8, 0);
  add_rows(points, {0.3, 0, 0.85}, {1, 0, 0}, 8, 0.4);
  const Features f = detect(points).features;
  expect_first_row_only(f, points, 0, 8);
  expect_first_row_only(f, points, 168, 8);
  for (std::size_t i = 0; i < f.size(); ++i) {
    if (f.kind[i] != PointKind::edge || std::abs(points[i].y) > 6) continue;
    EXPECT_GT(f.angle[i], radians(30));
    EXPECT_GT(std::abs(f.direction[i].y), 0.9);
  }
}

TEST(Narrow, BothEndsOfAChamferOfTwoRowsAreEdges) {
  std::vector<Vec3> points;
  add_rows(points, {0.8, 0, 0}, {1, 0, 0}, 8, 0);
  add_rows(points, {0, 0, -0.8}, {0, 0, -1}, 8, 0.4);
  const Features f = detect(points).features;
  expect_first_row_only(f, points, 0, 8);
  expect_first_row_only(f, points, 168, 8);
}

// A drill hole of twelve points around: its wall bends by 30 degrees from point to point, and
// still only its rims are edges.
TEST(Narrow, OfASmallHoleTheRimsAreEdgesAndTheWallIsNot) {
  std::vector<Vec3> points;
  const double radius = 2;
  for (const double z : {0.0, 5.0})
    for (int i = -8; i <= 8; ++i)
      for (int j = -8; j <= 8; ++j) {
        const Vec3 p{i + 0.3 * std::sin(3.0 * j), j + 0.3 * std::sin(5.0 * i), z};
        if (std::hypot(p.x, p.y) > radius + 0.5) points.push_back(p);
      }
  const std::size_t wall = points.size();
  for (int row = 0; row <= 5; ++row)
    for (int i = 0; i < 12; ++i) {
      const double turn = 2 * pi * (i + 0.5 * row) / 12;
      points.push_back({radius * std::cos(turn), radius * std::sin(turn), row * 1.0});
    }
  const Features f = detect(points).features;
  int rims = 0, inside = 0;
  for (std::size_t i = wall; i < points.size(); ++i) {
    const bool sharp = f.kind[i] == PointKind::edge || f.kind[i] == PointKind::corner;
    (points[i].z == 0 || points[i].z == 5 ? rims : inside) += sharp;
  }
  EXPECT_GE(rims, 22);
  EXPECT_LE(inside, 2);
}

// Where samples lie right on an edge, those beside it are not on it too.
TEST(Narrow, SamplesOnTheEdgeLeaveNoneBesideIt) {
  std::vector<Vec3> points;
  add_rows(points, {0, 0, 0}, {1, 0, 0}, 1, 0);
  add_rows(points, {0.5, 0, 0}, {1, 0, 0}, 8, 0.4);
  add_rows(points, {0, 0, -0.5}, {0, 0, -1}, 8, 0.6);
  const Features f = detect(points).features;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double away = std::hypot(points[i].x, points[i].z);
    if (std::abs(points[i].y) > 7 || away > 5) continue;
    EXPECT_EQ(f.kind[i] == PointKind::edge, away == 0) << away;
  }
}

// Where samples are missing by chance the surface goes on; a thin wall's other side is no reason
// to think it ends.
TEST(Narrow, ChanceGapsOfAThinWallAreNoEdges) {
  SynthOptions options{.shape = "plate", .sampling = Sampling::random};
  options.size = 1.5;
  options.seed = 15;
  const SynthCloud s = make_cloud(options);
  const Features f = detect(s.cloud.points).features;
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < f.size(); ++i)
    wrong += f.kind[i] == PointKind::edge && edge_distance(s.shape, s.exact[i]) > 4 * s.spacing;
  EXPECT_LE(wrong * 500, f.size());
}

// A quarter round bends off its flats steadily: no end anywhere.
TEST(Narrow, RoundedBoxesHaveNoEnds) {
  SynthOptions options{.shape = "fillet-box", .sampling = Sampling::random, .points = 10000};
  options.size = 6;
  options.seed = 15;
  const Features f = detect(make_cloud(options).cloud.points).features;
  EXPECT_LE(f.counts()[1], 4u);
}

// Marks on random samples, more than two spacings h from any edge.
std::size_t far_marks(const char* shape, double angle, std::uint64_t seed) {
  SynthOptions options;
  options.shape = shape;
  options.angle = angle;
  options.sampling = Sampling::random;
  options.seed = seed;
  const SynthCloud synth = make_cloud(options);
  const FeatureTruth truth = read_truth(synth.cloud, synth.spacing, synth.lattice);
  const auto marked = sharp_flags(detect(synth.cloud.points).features);
  std::size_t far = 0;
  for (std::size_t i = 0; i < marked.size(); ++i)
    far += marked[i] && truth.edge_distance[i] > 2 * synth.spacing;
  return far;
}

// The far wall seen through a gap that chance leaves between the samples of the near one.
TEST(Narrow, InAnAcuteWedgeGapsBetweenSamplesAreNoRims) {
  for (const std::uint64_t seed : {8, 12, 14}) EXPECT_EQ(far_marks("wedge", radians(25), seed), 0U);
}

// Where samples are sparse, a quadric does not follow a rounding of four spacings.
TEST(Narrow, SlightBendsBetweenSheetsThatFitBadlyAreNoEdges) {
  for (const std::uint64_t seed : {6, 7}) EXPECT_LE(far_marks("fillet-box", 0, seed), 10U);
}

}  // namespace
}  // namespace spigolo
