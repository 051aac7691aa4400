// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "spigolo/pipeline/lines.h"
#include "spigolo/pipeline/mesh.h"
#include "spigolo/pipeline/smooth.h"
#include "spigolo/synth/synth.h"
#include "support/clouds.h"

namespace spigolo {
namespace {

struct Outcome {
  std::vector<PointKind> kind;  // by point
  std::vector<Vec3> smooth;     // by point
  std::vector<std::vector<Vec3>> curves;
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

Outcome outcome_of(const std::vector<Vec3>& points, int threads) {
  Job job;
  job.threads = threads;
  const Lines lines = find_lines(points, {}, job);
  const MeshedCloud meshed = mesh_cloud(points, {}, job);
  Outcome outcome{lines.detection.features.kind,
                  smooth(points, {}, job).position,
                  {},
                  meshed.sharp.mesh.vertices.points,
                  meshed.sharp.mesh.triangles};
  for (const FeatureCurve& curve : lines.network.curves) outcome.curves.push_back(curve.points);
  return outcome;
}

void expect_same(const Outcome& a, const Outcome& b) {
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_EQ(a.smooth, b.smooth);
  EXPECT_EQ(a.curves, b.curves);
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.triangles, b.triangles);
}

std::vector<Vec3> boxhole(double noise) {
  return make_cloud(
             {.shape = "boxhole", .sampling = Sampling::blue, .points = 1000, .noise = noise})
      .cloud.points;
}

TEST(Determinism, ThreadsChangeNoBitOfAnyStage) {
  for (const double noise : {0.0, 0.25}) {
    const std::vector<Vec3> points = boxhole(noise);
    const Outcome one = outcome_of(points, 1);
    EXPECT_FALSE(one.curves.empty());
    EXPECT_FALSE(one.triangles.empty());
    for (const int threads : {2, 3, 8}) {
      SCOPED_TRACE(threads);
      expect_same(one, outcome_of(points, threads));
    }
  }
}

TEST(Determinism, TheOrderOfThePointsChangesNoBitOfAnyStage) {
  for (const double noise : {0.0, 0.25}) {
    const std::vector<Vec3> points = boxhole(noise);
    Outcome was = outcome_of(points, 0);
    was.kind = test::shuffled(was.kind, 7);
    was.smooth = test::shuffled(was.smooth, 7);
    expect_same(was, outcome_of(test::shuffled(points, 7), 0));
  }
}

// A power of two changes exponents only, so every decision must come out alike.
TEST(Determinism, APowerOfTwoChangesNoBitOfAnyStage) {
  for (const double noise : {0.0, 0.25}) {
    std::vector<Vec3> points = boxhole(noise);
    const Outcome was = outcome_of(points, 0);
    for (Vec3& p : points) p = p * 0.125;
    Outcome is = outcome_of(points, 0);
    for (Vec3& p : is.smooth) p = p * 8;
    for (auto& curve : is.curves)
      for (Vec3& p : curve) p = p * 8;
    for (Vec3& p : is.vertices) p = p * 8;
    expect_same(was, is);
  }
}

}  // namespace
}  // namespace spigolo
