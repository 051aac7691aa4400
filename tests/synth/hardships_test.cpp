// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/synth/hardships_test.cpp - uneven density, scan lines, occlusion, outliers: as stated
#include <gtest/gtest.h>

#include <set>

#include "spigolo/core/error.h"
#include "spigolo/synth/sampling.h"
#include "spigolo/synth/synth.h"

namespace spigolo {
namespace {

const std::vector<double>& values(const SynthCloud& made, const char* name) {
  return made.cloud.find(name)->values;
}

double off_surface(const SynthCloud& made) {
  double worst = 0;
  for (const Vec3& p : made.exact) worst = std::max(worst, surface_distance(made.shape, p));
  return worst;
}

/// Samples per area in thin slices at both ends of the box's x axis, on its four long sides.
double density_ratio(const SynthCloud& made) {
  double low = 0, high = 0;
  for (const Vec3& p : made.exact) {
    low += p.x > 1e-9 && p.x < 0.1;
    high += p.x > 0.9 && p.x < 1 - 1e-9;
  }
  return high / low;
}

TEST(DensityGradient, IsTheStatedRatio) {
  for (const Sampling sampling : {Sampling::random, Sampling::blue}) {
    const SynthCloud made =
        make_cloud({.shape = "box", .sampling = sampling, .points = 20000, .density_gradient = 10});
    ASSERT_EQ(made.cloud.size(), 20000u);
    EXPECT_LT(off_surface(made), 1e-12);
    // slices of a tenth: their middles are .9 of the length apart
    EXPECT_NEAR(density_ratio(made), std::pow(10, 0.9), 0.9);
    const auto& h = values(made, "truth_spacing");
    const auto [least, most] = std::minmax_element(h.begin(), h.end());
    EXPECT_NEAR(*most / *least, std::sqrt(10), 0.02);
    for (std::size_t i = 0; i < h.size(); ++i)
      EXPECT_EQ(values(made, "truth_feature")[i] != 0,
                edge_distance(made.shape, made.exact[i]) <= 0.75 * h[i]);
  }
}

TEST(DensityGradient, BlueSamplesKeepTheirLocalDistance) {
  const SynthCloud made = make_cloud(
      {.shape = "box", .sampling = Sampling::blue, .points = 3000, .density_gradient = 10});
  const auto& h = values(made, "truth_spacing");
  for (std::size_t i = 0; i < made.exact.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      ASSERT_GT(distance(made.exact[i], made.exact[j]), 0.7 * std::min(h[i], h[j]));
}

TEST(DensityGradient, OneIsNoGradient) {
  const SynthOptions plain{.shape = "boxhole", .sampling = Sampling::blue, .points = 2000};
  SynthOptions one = plain;
  one.density_gradient = 1;
  EXPECT_EQ(make_cloud(plain).exact, make_cloud(one).exact);
  EXPECT_EQ(make_cloud(plain).cloud.find("truth_spacing"), nullptr);
}

TEST(Scan, LinesLieInPlanesAndAreFourTimesDenserAlong) {
  for (const char* name : {"box", "cylinders", "torus", "planes"}) {
    const Shape shape = make_shape({.shape = name});
    Random random(4);
    const ScanLines lines = sample_scan(shape, 4000, random, {});
    ASSERT_EQ(lines.points.size(), 4000u);
    EXPECT_DOUBLE_EQ(lines.across, 4 * lines.along);
    const Vec3 d = normalized({1, 0.7, 0.45});
    const double first = dot(lines.points[0], d);
    double least = infinity;
    for (std::size_t i = 0; i < lines.points.size(); ++i) {
      const double line = (dot(lines.points[i], d) - first) / lines.across;
      EXPECT_NEAR(line, std::round(line), 1e-6);
      EXPECT_LT(surface_distance(shape, lines.points[i]), 1e-12 * shape.radius);
      for (std::size_t j = 0; j < i; ++j)
        least = std::min(least, distance(lines.points[i], lines.points[j]));
    }
    EXPECT_GT(least, 0.55 * lines.along) << name;
  }
}

TEST(View, SeesOnlyWhatNothingHides) {
  // from one place no ray to a sample of a convex solid passes through the solid: all samples lie
  // on faces whose outer side looks at one half space, so at most three of a box's six faces
  const SynthCloud one =
      make_cloud({.shape = "box", .sampling = Sampling::view, .points = 3000, .views = 1});
  EXPECT_LT(off_surface(one), 1e-12);
  EXPECT_NEAR(static_cast<double>(one.cloud.size()), 3000, 300);
  auto faces = [](const SynthCloud& made) {
    std::set<std::size_t> seen;
    for (const Vec3& p : made.exact)
      for (std::size_t f = 0; f < made.shape.patches.size(); ++f)
        if (distance(p, made.shape.patches[f].nearest(p)) < 1e-12) seen.insert(f);
    return seen.size();
  };
  EXPECT_EQ(faces(one), 3u);
  EXPECT_EQ(
      faces(make_cloud({.shape = "box", .sampling = Sampling::view, .points = 3000, .views = 8})),
      6u);
}

TEST(View, HalfSeenEdgesAreBorders) {
  const SynthCloud made =
      make_cloud({.shape = "box", .sampling = Sampling::view, .points = 6000, .views = 1});
  const auto &kind = values(made, "truth_kind"), &feature = values(made, "truth_feature");
  const auto &edge = values(made, "truth_edge_distance"), &h = values(made, "truth_spacing");
  std::size_t borders = 0, edges = 0;
  for (std::size_t i = 0; i < kind.size(); ++i) {
    borders += kind[i] == 4, edges += kind[i] == 1;
    EXPECT_EQ(kind[i] != 0, edge[i] <= 0.75 * h[i]);
    EXPECT_EQ(feature[i] != 0, kind[i] != 0 && kind[i] != 4);
  }
  // three faces meet in three inner edges (a row on each side) and end in six outer ones (one row)
  EXPECT_GT(borders, 100u);
  EXPECT_GT(edges, 50u);
}

TEST(NoiseGradient, IsTheStatedRatio) {
  const SynthCloud made = make_cloud({.shape = "box",
                                      .sampling = Sampling::random,
                                      .points = 40000,
                                      .noise = 0.2,
                                      .noise_gradient = 10});
  double sums[2] = {0, 0}, counts[2] = {0, 0};
  for (std::size_t i = 0; i < made.exact.size(); ++i) {
    const double y = made.exact[i].y / 0.8;  // the second longest side
    if (y > 0.05 && y < 0.95) continue;
    const bool high = y > 0.5;
    sums[high] += squared_distance(made.exact[i], made.cloud.points[i]), ++counts[high];
  }
  const double ratio = std::sqrt(sums[1] / counts[1] / (sums[0] / counts[0]));
  EXPECT_NEAR(ratio, std::pow(10, 0.97), 0.6);
}

TEST(Outliers, StandBehindAndAreNoFeatures) {
  SynthOptions options{.shape = "boxhole", .sampling = Sampling::blue, .points = 2000};
  const SynthCloud clean = make_cloud(options);
  options.noise = 0.2, options.outliers = 0.05, options.duplicates = 0.1;
  const SynthCloud made = make_cloud(options);
  ASSERT_EQ(made.cloud.size(), 2000u + 200 + 100);
  EXPECT_NO_THROW(validate(made.cloud));
  const auto& outlier = values(made, "truth_outlier");
  for (std::size_t i = 0; i < made.cloud.size(); ++i) {
    EXPECT_EQ(outlier[i] != 0, i >= 2200);
    if (i < 2000) {
      EXPECT_EQ(made.exact[i], clean.exact[i]);
    }
    if (i >= 2200) {
      EXPECT_EQ(values(made, "truth_feature")[i], 0);
      EXPECT_EQ(made.exact[i], made.cloud.points[i]);
      EXPECT_EQ(values(made, "truth_edge_distance")[i], edge_distance(made.shape, made.exact[i]));
    }
  }
}

TEST(Duplicates, RepeatAPlaceAndItsTruth) {
  const SynthCloud made =
      make_cloud({.shape = "box", .points = 2000, .noise = 0.1, .duplicates = 0.1});
  const std::size_t n = made.cloud.size() * 10 / 11;
  for (std::size_t i = n; i < made.cloud.size(); ++i) {
    const auto first =
        std::find(made.cloud.points.begin(), made.cloud.points.end(), made.cloud.points[i]);
    const auto of = static_cast<std::size_t>(first - made.cloud.points.begin());
    ASSERT_LT(of, n + 1);
    for (const Attribute& a : made.cloud.attributes) EXPECT_EQ(a.values[i], a.values[of]);
  }
}

TEST(Hardships, RepeatForAnyThreads) {
  for (const Sampling sampling : {Sampling::scan, Sampling::view}) {
    SynthOptions options{.shape = "l-prism", .sampling = sampling, .points = 3000};
    options.views = 3, options.outliers = 0.01, options.duplicates = 0.01, options.noise = 0.1;
    Job one, three;
    one.threads = 1, three.threads = 3;
    const SynthCloud a = make_cloud(options, one), b = make_cloud(options, three);
    EXPECT_EQ(a.cloud.points, b.cloud.points);
    for (std::size_t i = 0; i < a.cloud.attributes.size(); ++i)
      EXPECT_EQ(a.cloud.attributes[i].values, b.cloud.attributes[i].values);
  }
}

TEST(Hardships, WrongOnesAreRefused) {
  EXPECT_THROW(make_cloud({.shape = "box", .density_gradient = 10}), UsageError);  // a lattice
  EXPECT_THROW(make_cloud({.shape = "cone", .sampling = Sampling::blue, .density_gradient = 0.5}),
               UsageError);
  EXPECT_THROW(make_cloud({.shape = "box", .noise_gradient = 0}), UsageError);
  EXPECT_THROW(make_cloud({.shape = "box", .duplicates = -0.1}), UsageError);
  EXPECT_THROW(make_cloud({.shape = "box", .outliers = not_a_number}), UsageError);
  EXPECT_THROW(make_cloud({.shape = "box", .sampling = Sampling::view, .views = 0}), UsageError);
  EXPECT_THROW(make_cloud({.shape = "pyramid", .sides = 2}), UsageError);
  EXPECT_THROW(make_cloud({.shape = "spike", .angle = pi}), UsageError);
}

}  // namespace
}  // namespace spigolo
