// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
#include "spigolo/detect/detect.h"

#include <gtest/gtest.h>

#include "spigolo/core/error.h"
#include "spigolo/measure/classification.h"
#include "spigolo/synth/synth.h"
#include "support/clouds.h"

namespace spigolo {
namespace {

SynthCloud synth(const std::string& shape, double angle = radians(90),
                 Sampling sampling = Sampling::automatic, std::size_t points = 0) {
  SynthOptions options;
  options.shape = shape;
  options.angle = angle;
  options.sampling = sampling;
  options.points = points;
  return make_cloud(options);
}

// A closed object has an outside, a single fold has none.
TEST(Detect, RidgesAndValleysAreToldApart) {
  for (const char* shape : {"l-prism", "steps", "star"})
    for (const double noise : {0.0, 0.1})
      for (const Sampling sampling : {Sampling::random, Sampling::blue}) {
        SynthOptions options;
        options.shape = shape;
        options.sampling = sampling;
        options.noise = noise;
        options.seed = 12;
        const SynthCloud s = make_cloud(options);
        const Features f = detect(s.cloud.points).features;
        std::size_t right = 0, wrong = 0;
        for (std::size_t i = 0; i < f.size(); ++i) {
          if (f.kind[i] != PointKind::edge || corner_distance(s.shape, s.exact[i]) < 3 * s.spacing)
            continue;
          const int truth = nearest_crease(s.shape, s.exact[i]).convex;
          ++(f.convex[i] == truth ? right : wrong);
        }
        EXPECT_GT(right, 300u) << shape;
        EXPECT_LE(wrong * 100, right) << shape << " noise " << noise;
      }
  for (const std::int8_t convex :
       detect(synth("wedge", half_pi, Sampling::blue, 6000).cloud.points).features.convex)
    ASSERT_EQ(convex, 0);
}

// The apex is the corner farthest from the base: it is named with as many sheets as there are
// sides.
TEST(Detect, CornersAreOfAnyValence) {
  for (const std::size_t sides : {3u, 4u, 5u}) {
    SynthOptions options;
    options.shape = "pyramid";
    options.sides = sides;
    options.sampling = Sampling::blue;
    options.points = 10000;
    options.seed = 9;
    const SynthCloud s = make_cloud(options);
    const Features f = detect(s.cloud.points).features;
    double top = -infinity;
    for (const Vec3& p : s.cloud.points) top = std::max(top, p.z);
    std::size_t meet = 0, others = 0;
    for (std::size_t i = 0; i < f.size(); ++i) {
      if (f.kind[i] != PointKind::corner) continue;
      std::size_t& most = s.cloud.points[i].z > 0.9 * top ? meet : others;
      most = std::max<std::size_t>(most, f.sheets[i]);
    }
    EXPECT_EQ(meet, sides);
    EXPECT_EQ(others, 3u) << sides << " sides";
  }
}

TEST(Detect, ConesHaveATipAndPyramidsACorner) {
  for (const Sampling sampling : {Sampling::random, Sampling::blue}) {
    const SynthCloud cone = synth("cone", 0, sampling, 10000);
    const Detection d = detect(cone.cloud.points);
    double nearest = infinity;
    for (const Vec3& p : cone.cloud.points)
      nearest = std::min(nearest, tip_distance(cone.shape, p));
    EXPECT_GE(d.features.counts()[3], nearest < 0.6 * d.spacing ? 1u : 0u);
    for (std::size_t i = 0; i < d.features.size(); ++i) {
      if (d.features.kind[i] != PointKind::tip) continue;
      EXPECT_LT(tip_distance(cone.shape, cone.cloud.points[i]), 1.5 * d.spacing);
      EXPECT_LT(tip_distance(cone.shape, d.features.crease_point[i]), 0.5 * d.spacing);
      EXPECT_NEAR(degrees(d.features.angle[i]), 180 - 2 * degrees(std::atan(0.5)), 8);
    }
    EXPECT_EQ(detect(synth("pyramid", 0, sampling, 10000).cloud.points).features.counts()[3], 0u);
    EXPECT_EQ(detect(synth("box", 0, sampling, 10000).cloud.points).features.counts()[3], 0u);
  }
}

// Lines four times denser along than across: the nearest neighbors alone lie on three of them.
TEST(Detect, ScanLinesHaveEdgesToo) {
  const SynthCloud s = synth("steps", 0, Sampling::scan, 10000);
  const Classification c = classify(sharp_flags(detect(s.cloud.points).features),
                                    read_truth(s.cloud, s.spacing, s.lattice), Scoring::tolerant);
  EXPECT_GT(c.f1, 0.9);
}

// Strength 0.9 means that nine in ten are right, on shapes and a seed that it was not fitted to.
TEST(Detect, StrengthIsCalibrated) {
  double expected = 0, right = 0, marked = 0;
  for (const char* shape : {"steps", "cylinder-hole", "lens"})
    for (const double noise : {0.25, 0.5}) {
      SynthOptions options;
      options.shape = shape;
      options.sampling = Sampling::random;
      options.points = 6000;
      options.noise = noise;
      options.seed = 8;
      const SynthCloud s = make_cloud(options);
      const FeatureTruth truth = read_truth(s.cloud, s.spacing, s.lattice);
      const Features f = detect(s.cloud.points).features;
      for (std::size_t i = 0; i < f.size(); ++i) {
        const bool sharp = f.kind[i] == PointKind::edge || f.kind[i] == PointKind::corner;
        const bool open = truth.edge_distance[i] <= 2 * s.spacing && !truth.feature[i];
        if (!sharp || open) continue;
        expected += static_cast<double>(f.strength[i]);
        right += truth.feature[i] ? 1 : 0;
        ++marked;
      }
    }
  EXPECT_NEAR(expected / marked, right / marked, 0.06);
}

// Half and all of the distance between the samples: what a single neighborhood cannot see.
TEST(Detect, FoldsShowThroughMuchNoise) {
  const auto f1 = [](double angle, double noise) {
    SynthOptions options;
    options.shape = angle > 0 ? "wedge" : "box";
    options.angle = radians(angle > 0 ? angle : 90);
    options.sampling = Sampling::blue;
    options.points = 4000;
    options.noise = noise;
    options.seed = 3;
    const SynthCloud s = make_cloud(options);
    return classify(sharp_flags(detect(s.cloud.points).features),
                    read_truth(s.cloud, s.spacing, s.lattice), Scoring::tolerant)
        .f1;
  };
  EXPECT_GT(f1(0, 0.5), 0.86);
  EXPECT_GT(f1(120, 0.5), 0.86);
  EXPECT_GT(f1(0, 1), 0.6);
  EXPECT_GT(f1(120, 1), 0.6);
}

TEST(Detect, CloudsBeyondTheLimitAreNamed) {
  SynthOptions options;
  options.shape = "box";
  options.sampling = Sampling::blue;
  options.points = 4000;
  const auto warnings = [&](double noise) {
    options.noise = noise;
    return detect(make_cloud(options).cloud.points).warnings;
  };
  EXPECT_TRUE(warnings(0.1).empty());
  ASSERT_EQ(warnings(0.3).size(), 1u);
  EXPECT_NE(warnings(0.3)[0].find("hides edges"), std::string::npos);
  ASSERT_EQ(warnings(1).size(), 1u);
  EXPECT_NE(warnings(1)[0].find("beyond"), std::string::npos);
}

// Noise ten times larger at one end: one estimate for the whole cloud takes the noisy end for
// edges.
TEST(Detect, NoiseMayDifferOverTheCloud) {
  for (const char* shape : {"steps", "sphere", "torus"}) {
    SynthOptions options;
    options.shape = shape;
    options.sampling = Sampling::blue;
    options.noise = 0.1;
    options.noise_gradient = 10;
    options.seed = 9;
    const SynthCloud s = make_cloud(options);
    const Classification c = classify(sharp_flags(detect(s.cloud.points).features),
                                      read_truth(s.cloud, s.spacing, s.lattice), Scoring::tolerant);
    EXPECT_LE(c.outliers, 10u) << shape;
    if (c.features > 0) {
      EXPECT_GT(c.f1, 0.93) << shape;
    }
  }
}

}  // namespace
}  // namespace spigolo
