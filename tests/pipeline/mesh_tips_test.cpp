// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/pipeline/mesh_tips_test.cpp - the apex of a cone is a vertex of its mesh
#include <gtest/gtest.h>

#include "spigolo/measure/distance.h"
#include "spigolo/pipeline/mesh.h"
#include "spigolo/synth/synth.h"

namespace spigolo {
namespace {

constexpr double nearly = 0.05;  // [spacings]

void expect_tips(const char* shape, Sampling sampling, std::size_t points, std::uint64_t seed = 5) {
  SynthOptions options;
  options.shape = shape;
  options.sampling = sampling;
  options.points = points;
  options.seed = seed;
  const SynthCloud cloud = make_cloud(options);
  ASSERT_FALSE(cloud.shape.tips.empty());
  const MeshedCloud meshed = mesh_cloud(cloud.cloud.points);
  EXPECT_TRUE(meshed.sharp.check.sound()) << shape;
  EXPECT_TRUE(meshed.sharp.check.closed()) << shape;
  for (const double d : distances_to_mesh(cloud.shape.tips, meshed.sharp.mesh, false))
    EXPECT_LT(d, nearly * meshed.spacing) << shape;
}

TEST(Tips, TheApexOfAConeIsAVertex) {
  expect_tips("cone", Sampling::blue, 4000);
  expect_tips("cone", Sampling::random, 10000);
}

// Labels call the samples around it an edge.
TEST(Tips, ACloudWhoseLabelsMissTheTip) { expect_tips("cone", Sampling::blue, 10000, 6); }

TEST(Tips, SoIsThatOfASpike) {
  expect_tips("spike", Sampling::blue, 4000);
  expect_tips("spike", Sampling::random, 4000);
}

}  // namespace
}  // namespace spigolo
