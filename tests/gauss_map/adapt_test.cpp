// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
#include "spigolo/gauss_map/adapt.h"

#include <gtest/gtest.h>

#include "spigolo/synth/synth.h"
#include "support/clouds.h"

namespace spigolo {
namespace {

struct Case {
  OrderedCloud cloud;
  Neighborhoods neighborhoods;
};

Case prepare(const std::string& shape, double noise) {
  SynthOptions options;
  options.shape = shape;
  options.noise = noise;
  Case result;
  result.cloud = order_cloud(make_cloud(options).cloud.points);
  result.neighborhoods = find_neighborhoods(KdTree(result.cloud), 20);
  return result;
}

std::vector<std::uint32_t> sharp_points(const GaussMapFeatures& features) {
  std::vector<std::uint32_t> sharp;
  for (std::uint32_t i = 0; i < features.test.size(); ++i)
    if (features.test[i].verdict == FeatureVerdict::sharp) sharp.push_back(i);
  return sharp;
}

TEST(Adapt, FeaturesAreASubsetOfTheCandidates) {
  for (const double noise : {0.0, 0.2}) {
    const Case c = prepare("planes", noise);
    const auto all = sharp_points(detect_global(c.cloud.points, c.neighborhoods, 20, {}));
    const auto kept = sharp_points(detect_adaptive(c.cloud.points, c.neighborhoods, {}));
    EXPECT_LT(kept.size(), all.size());
    EXPECT_TRUE(std::includes(all.begin(), all.end(), kept.begin(), kept.end()));
  }
}

TEST(Adapt, StopsOnlyWhereTheTextStops) {
  const AdaptOptions options;
  const Case c = prepare("planes", 0.1);
  const auto features = detect_adaptive(c.cloud.points, c.neighborhoods, options);
  for (const std::uint32_t i : sharp_points(features)) {
    const std::size_t k = 20u - features.steps[i];
    ASSERT_GE(k, options.min_k);
    if (k == options.min_k) continue;
    const auto row = c.neighborhoods.of(i).first(k);
    const auto flagged = std::count_if(row.begin(), row.end(), [&](auto j) {
      return features.test[j].verdict == FeatureVerdict::sharp;
    });
    EXPECT_LT(static_cast<double>(flagged), options.crowded * static_cast<double>(k));
  }
}

TEST(Adapt, SameForAnyNumberOfThreads) {
  const Case c = prepare("planes", 0.2);
  Job one;
  one.threads = 1;
  const auto reference = sharp_points(detect_adaptive(c.cloud.points, c.neighborhoods, {}, one));
  for (const int threads : {2, 3, 8}) {
    Job job;
    job.threads = threads;
    EXPECT_EQ(sharp_points(detect_adaptive(c.cloud.points, c.neighborhoods, {}, job)), reference);
  }
}

}  // namespace
}  // namespace spigolo
