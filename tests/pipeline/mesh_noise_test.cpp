// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "spigolo/pipeline/mesh.h"
#include "spigolo/synth/synth.h"

namespace spigolo {
namespace {

MeshedCloud mesh_noisy(const char* shape, std::uint64_t seed) {
  SynthOptions options;
  options.shape = shape;
  options.sampling = Sampling::blue;
  options.points = 2500;
  options.noise = 0.5;
  options.seed = seed;
  return mesh_cloud(make_cloud(options).cloud.points);
}

// Some of these clouds are torn at the length asked for: noise drew a place together. Other
// vertices on the same surface close it, and the run says so.
TEST(MeshNoise, ATornMeshIsMadeAgainWithOtherVertices) {
  int again = 0;
  for (const std::uint64_t seed : {1, 2, 5, 8}) {
    const MeshedCloud meshed = mesh_noisy("l-prism", seed);
    EXPECT_TRUE(meshed.sharp.check.closed()) << seed;
    EXPECT_TRUE(meshed.sharp.check.sound()) << seed;
    EXPECT_EQ(meshed.sharp.check.euler, 2) << seed;
    if (meshed.sharp.length_share == 1) continue;
    ++again;
    ASSERT_FALSE(meshed.warnings.empty());
    EXPECT_NE(meshed.warnings.front().find("of the length asked for"), std::string::npos);
  }
  EXPECT_GT(again, 0);
}

}  // namespace
}  // namespace spigolo
