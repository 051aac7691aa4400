// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/synth/thesis_sets_test.cpp - the lattices of the thesis have exactly its counts
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>

#include "spigolo/synth/synth.h"

namespace spigolo {
namespace {

std::size_t features(const SynthCloud& made) {
  std::size_t n = 0;
  for (const double f : made.cloud.find("truth_feature")->values) n += f != 0;
  return n;
}

struct Expected {
  const char* shape;
  std::size_t points, features, corners;
  double spacing;
};

class ThesisSet : public testing::TestWithParam<Expected> {};

TEST_P(ThesisSet, HasTheStatedCounts) {
  const Expected e = GetParam();
  const SynthCloud made = make_cloud({.shape = e.shape});
  EXPECT_TRUE(made.lattice);
  EXPECT_EQ(made.cloud.size(), e.points);
  EXPECT_EQ(features(made), e.features);
  EXPECT_NEAR(made.spacing, e.spacing, 1e-3 * e.spacing);
  std::size_t corners = 0;
  for (const double k : made.cloud.find("truth_kind")->values) corners += k == 2;
  EXPECT_EQ(corners, e.corners);
  for (const Vec3& p : made.exact) EXPECT_LT(surface_distance(made.shape, p), 1e-12 * 100);
}

INSTANTIATE_TEST_SUITE_P(All, ThesisSet,
                         testing::Values(Expected{"cube", 10088, 488, 8, 1},
                                         Expected{"planes", 6400, 256, 0, 1},
                                         Expected{"hole", 57939, 1350, 8, 1},
                                         Expected{"hole17k", 17381, 838, 8, 0.25},
                                         Expected{"wedge", 2460, 60, 0, 1}),
                         [](const auto& set) { return set.param.shape; });

TEST(ThesisSets, HolesAgreeWithACountOfTheirParts) {
  for (const char* shape : {"hole", "hole17k"}) {
    const bool small = std::string(shape) == "hole17k";
    const long n = small ? 49 : 91, m = small ? 133 : 137;
    const double r = static_cast<double>(m) / (2 * pi);  // [spacings]
    long removed = 0;
    for (long i = 0; i < n; ++i)
      for (long j = 0; j < n; ++j)
        removed += std::hypot(double(2 * i - n + 1) / 2, double(2 * j - n + 1) / 2) <= r + 0.5;
    const long total = 6 * n * n - 12 * n + 8 - 2 * removed + m * n;
    EXPECT_EQ(make_cloud({.shape = shape}).cloud.size(), static_cast<std::size_t>(total));
  }
}

TEST(ThesisSets, ScaleToTheWishedNumber) {
  const SynthCloud cube = make_cloud({.shape = "cube", .points = 1000});
  EXPECT_EQ(cube.cloud.size(), 6u * 13 * 13 + 2);
  EXPECT_EQ(features(cube), 12u * 12 + 8);
  for (const char* shape : {"hole", "hole17k", "planes", "wedge", "box", "l-prism", "steps"}) {
    const SynthCloud made = make_cloud({.shape = shape, .points = 30000});
    EXPECT_TRUE(made.lattice);
    EXPECT_NEAR(static_cast<double>(made.cloud.size()), 30000, 900) << shape;
    EXPECT_GT(features(made), 0u);
  }
  const SynthCloud hole = make_cloud({.shape = "hole", .points = 57939});
  EXPECT_EQ(features(hole), 1350u);
}

TEST(ThesisSets, LatticesHaveNoPointTwice) {
  for (const ShapeInfo& known : synth_shapes()) {
    if (!known.lattice) continue;
    SynthCloud made = make_cloud({.shape = known.name});
    auto less = [](const Vec3& a, const Vec3& b) {
      return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    };
    std::sort(made.exact.begin(), made.exact.end(), less);
    EXPECT_EQ(std::adjacent_find(made.exact.begin(), made.exact.end()), made.exact.end());
  }
}

TEST(ThesisSets, CellLatticesFollowEuler) {
  // a closed lattice of quads round a ball: points = quads + 2; features from the edge lengths
  const SynthCloud box = make_cloud({.shape = "box", .points = 94 * 36 + 2});
  EXPECT_EQ(box.cloud.size(), 94u * 36 + 2);
  EXPECT_EQ(features(box), 4u * 6 * (5 + 4 + 3) - 12 + 8);
  const SynthCloud corner = make_cloud({.shape = "l-prism", .points = 14 * 100 + 2});
  EXPECT_EQ(corner.cloud.size(), 14u * 100 + 2);
  EXPECT_EQ(features(corner), 10u * (2 * 8 + 6) - 18 + 12);
}

}  // namespace
}  // namespace spigolo
