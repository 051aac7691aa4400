// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/measure/classification_test.cpp - scores by hand count and on the sets of the thesis
#include "spigolo/measure/classification.h"

#include <gtest/gtest.h>

#include <string>

#include "spigolo/core/error.h"
#include "spigolo/synth/synth.h"

namespace spigolo {
namespace {

/// Distances 0, 0, .5, 1, 1.4, 1.9, 5 on a lattice of spacing 1 (the first two are features).
FeatureTruth seven_points(bool lattice) {
  FeatureTruth truth{{}, {0, 0, 0.5, 1, 1.4, 1.9, 5}, 1, lattice};
  for (const double d : truth.edge_distance) truth.feature.push_back(d <= (lattice ? 0 : 0.75));
  return truth;
}

const std::vector<std::uint8_t> all_flagged(7, 1);

TEST(Classify, ThinCountsEveryPoint) {
  const Classification c = classify(all_flagged, seven_points(true), Scoring::thin);
  EXPECT_EQ(c.points, 7u);
  EXPECT_EQ(c.features, 2u);
  EXPECT_EQ(c.hits, 2u);
  EXPECT_EQ(c.outliers, 5u);
  EXPECT_EQ(c.ignored, 0u);
  EXPECT_EQ(c.recall, 1);
  EXPECT_DOUBLE_EQ(c.precision, 2.0 / 7);
  EXPECT_DOUBLE_EQ(c.f1, 2 * c.precision * c.recall / (c.precision + c.recall));
}

TEST(Classify, EachScoringIgnoresItsBand) {
  auto outliers = [](bool lattice, Scoring scoring) {
    return classify(all_flagged, seven_points(lattice), scoring).outliers;
  };
  EXPECT_EQ(outliers(true, Scoring::thin), 5u);
  EXPECT_EQ(outliers(true, Scoring::tolerant), 2u);
  EXPECT_EQ(outliers(false, Scoring::thin), 4u);
  EXPECT_EQ(outliers(false, Scoring::tolerant), 1u);
}

TEST(Classify, MissedFeaturesAreNeverIgnored) {
  const std::vector<std::uint8_t> flags = {1, 0, 0, 0, 0, 0, 1};
  for (const Scoring scoring : {Scoring::thin, Scoring::tolerant}) {
    const Classification c = classify(flags, seven_points(true), scoring);
    EXPECT_EQ(c.features, 2u);
    EXPECT_EQ(c.missed, 1u);
    EXPECT_EQ(c.hits, 1u);
    EXPECT_EQ(c.outliers, 1u);
    EXPECT_EQ(c.flagged, c.hits + c.outliers);
    EXPECT_DOUBLE_EQ(c.f1, 0.5);
    EXPECT_EQ(c.points + c.ignored, 7u);
  }
}

TEST(Classify, NothingToFindAndNothingFoundIsPerfect) {
  const FeatureTruth smooth{{0, 0}, {infinity, infinity}, 1, false};
  const std::vector<std::uint8_t> none = {0, 0}, one = {0, 1};
  EXPECT_EQ(classify(none, smooth, Scoring::tolerant).f1, 1);
  const Classification c = classify(one, smooth, Scoring::tolerant);
  EXPECT_EQ(c.f1, 0);
  EXPECT_EQ(c.precision, 0);
  EXPECT_EQ(c.recall, 1);
  EXPECT_THROW(classify(std::vector<std::uint8_t>{1}, smooth, Scoring::thin), UsageError);
}

TEST(Classify, TheTruthScoresPerfectly) {
  for (const char* shape : {"hole", "planes"}) {
    const SynthCloud made = make_cloud({.shape = shape});
    const FeatureTruth truth = read_truth(made.cloud, made.spacing, made.lattice);
    const Classification c = classify(truth.feature, truth, Scoring::thin);
    EXPECT_EQ(c.f1, 1);
    EXPECT_EQ(c.hits, std::string(shape) == "hole" ? 1350u : 256u);
  }
  EXPECT_THROW(read_truth({}, 1, true), NoResultError);
}

TEST(Classify, SharpFlagsLeaveOutBorders) {
  Features features;
  features.assign_surface(5);
  for (std::size_t i = 0; i < 5; ++i) features.kind[i] = static_cast<PointKind>(i);
  EXPECT_EQ(sharp_flags(features), (std::vector<std::uint8_t>{0, 1, 1, 1, 0}));
}

TEST(Deviation, IsOneWay) {
  const std::vector<Vec3> real = {{0, 0, 0}, {10, 0, 0}, {20, 0, 0}};
  const std::vector<Vec3> estimated = {{1, 0, 0}, {10, 3, 0}};
  const FeatureDeviation d = feature_deviation(estimated, real);
  EXPECT_EQ(d.max, 3);
  EXPECT_EQ(d.mean, 2);
  EXPECT_EQ(d.estimated, 2u);
  EXPECT_EQ(d.real, 3u);
  EXPECT_EQ(feature_deviation({}, real).max, 0);
  EXPECT_THROW(feature_deviation(estimated, {}), NoResultError);
}

TEST(Deviation, OfFeaturesUnderNoiseIsTheNoise) {
  const SynthCloud made = make_cloud({.shape = "hole17k", .noise_percent = 0.8});
  std::vector<Vec3> real, estimated;
  const auto& feature = made.cloud.find("truth_feature")->values;
  for (std::size_t i = 0; i < feature.size(); ++i)
    if (feature[i] != 0) real.push_back(made.exact[i]), estimated.push_back(made.cloud.points[i]);
  const FeatureDeviation d = feature_deviation(estimated, real);
  const double ball = 0.008 * 8.5;  // less than half a spacing: everyone's nearest is his own
  EXPECT_LE(d.max, ball);
  EXPECT_NEAR(d.mean, 0.75 * ball, 0.02 * ball);
}

}  // namespace
}  // namespace spigolo
