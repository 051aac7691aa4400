// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/synth/cloud_test.cpp - truth, noise, seeds and threads of make_cloud
#include <gtest/gtest.h>

#include <cstring>

#include "spigolo/core/error.h"
#include "spigolo/synth/synth.h"

namespace spigolo {
namespace {

const std::vector<double>& values(const SynthCloud& made, const char* name) {
  return made.cloud.find(name)->values;
}

bool same_bytes(const SynthCloud& a, const SynthCloud& b) {
  if (a.cloud.size() != b.cloud.size() || a.spacing != b.spacing) return false;
  if (std::memcmp(a.cloud.points.data(), b.cloud.points.data(), a.cloud.size() * sizeof(Vec3)) != 0)
    return false;
  for (std::size_t i = 0; i < a.cloud.attributes.size(); ++i)
    if (a.cloud.attributes[i].values != b.cloud.attributes[i].values) return false;
  return a.cloud.attributes.size() == b.cloud.attributes.size();
}

TEST(Truth, OffTheLatticeFeaturesAreNearAnEdge) {
  for (const char* shape : {"boxhole", "cone", "cylinders", "sphere", "planes"}) {
    const SynthCloud made =
        make_cloud({.shape = shape, .sampling = Sampling::blue, .points = 3000, .noise = 0.3});
    EXPECT_NO_THROW(validate(made.cloud));
    for (std::size_t i = 0; i < made.exact.size(); ++i) {
      const double d = edge_distance(made.shape, made.exact[i]);
      EXPECT_EQ(values(made, "truth_edge_distance")[i], d > 1e-12 * made.shape.radius ? d : 0);
      EXPECT_EQ(values(made, "truth_feature")[i] != 0, d <= 0.75 * made.spacing);
      EXPECT_EQ(values(made, "truth_x")[i], made.exact[i].x);
      EXPECT_EQ(values(made, "truth_y")[i], made.exact[i].y);
      EXPECT_EQ(values(made, "truth_z")[i], made.exact[i].z);
    }
  }
}

TEST(Truth, BordersAreNoFeatures) {
  const SynthCloud made = make_cloud({.shape = "dome", .sampling = Sampling::random});
  std::size_t borders = 0;
  for (std::size_t i = 0; i < made.exact.size(); ++i) {
    const bool near = made.exact[i].z < 0.7 * made.spacing;
    borders += near;
    EXPECT_TRUE(!near || values(made, "truth_kind")[i] == 4);
    EXPECT_EQ(values(made, "truth_feature")[i], 0);
    EXPECT_EQ(values(made, "truth_edge_distance")[i], infinity);
  }
  EXPECT_GT(borders, 20u);
}

TEST(Truth, NoNoiseNoExtraColumns) {
  const SynthCloud made = make_cloud({.shape = "cube"});
  EXPECT_EQ(made.cloud.find("truth_x"), nullptr);
  EXPECT_EQ(made.cloud.points, made.exact);
}

TEST(Truth, ConeHasItsTip) {
  const SynthCloud made =
      make_cloud({.shape = "cone", .sampling = Sampling::blue, .points = 20000});
  std::size_t tips = 0;
  for (const double k : values(made, "truth_kind")) tips += k == 3;
  EXPECT_GE(tips, 1u);
  EXPECT_LE(tips, 4u);
}

TEST(Noise, HasTheWantedSize) {
  const SynthCloud gauss = make_cloud({.shape = "cube", .noise = 0.5});
  double squares = 0;
  for (std::size_t i = 0; i < gauss.exact.size(); ++i)
    squares += squared_distance(gauss.cloud.points[i], gauss.exact[i]);
  const double n = 3 * static_cast<double>(gauss.exact.size());
  EXPECT_NEAR(std::sqrt(squares / n), 0.5 * gauss.spacing, 0.5 * 4 / std::sqrt(2 * n));

  const SynthCloud ball = make_cloud({.shape = "hole17k", .noise_percent = 0.8});
  const double r = 0.008 * 8.5;
  double largest = 0, sum = 0;
  for (std::size_t i = 0; i < ball.exact.size(); ++i) {
    const double d = distance(ball.cloud.points[i], ball.exact[i]);
    largest = std::max(largest, d), sum += d;
  }
  EXPECT_LE(largest, r * (1 + 1e-12));
  EXPECT_GT(largest, 0.999 * r);
  EXPECT_NEAR(sum / static_cast<double>(ball.exact.size()), 0.75 * r, 0.01 * r);
}

TEST(Noise, MovesTheSamplesButNotTheTruth) {
  SynthOptions options{.shape = "boxhole", .sampling = Sampling::blue, .points = 3000};
  const SynthCloud clean = make_cloud(options);
  options.noise = 0.4;
  const SynthCloud noisy = make_cloud(options);
  EXPECT_EQ(clean.exact, noisy.exact);
  EXPECT_EQ(values(clean, "truth_feature"), values(noisy, "truth_feature"));
  EXPECT_EQ(clean.spacing, noisy.spacing);
}

TEST(Repeats, SameSeedSameBytesForAnyThreads) {
  for (const Sampling sampling : {Sampling::lattice, Sampling::random, Sampling::blue}) {
    SynthOptions options{.shape = "box", .sampling = sampling, .points = 4000, .noise = 0.1};
    Job one, three;
    one.threads = 1, three.threads = 3;
    const SynthCloud first = make_cloud(options, one);
    EXPECT_TRUE(same_bytes(first, make_cloud(options, three)));
    options.seed = 2;
    EXPECT_FALSE(same_bytes(first, make_cloud(options, one)));
  }
}

TEST(Options, WrongOnesAreRefused) {
  EXPECT_THROW(make_cloud({.shape = "cub"}), UsageError);
  EXPECT_THROW(make_cloud({.shape = "sphere", .sampling = Sampling::lattice}), UsageError);
  EXPECT_THROW(make_cloud({.shape = "cube", .noise = -1}), UsageError);
  EXPECT_THROW(make_cloud({.shape = "cube", .noise_percent = not_a_number}), UsageError);
  EXPECT_THROW(make_cloud({.shape = "wedge", .angle = 0.01}), UsageError);
  EXPECT_THROW(make_cloud({.shape = "plate", .size = 0}), UsageError);
  EXPECT_THROW(make_cloud({.shape = "fillet-box", .points = 100, .size = 20}), UsageError);
}

TEST(Options, SizeIsInMeanSpacings) {
  for (const double size : {2.5, 7.0}) {
    const SynthCloud made = make_cloud({.shape = "plate", .points = 5000, .size = size});
    double top = 0;
    for (const Corner& corner : made.shape.corners) top = std::max(top, corner.position.z);
    EXPECT_NEAR(top, size * std::sqrt(area(made.shape) / 5000), 1e-9);
  }
}

}  // namespace
}  // namespace spigolo
