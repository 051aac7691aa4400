// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/gauss_map/adapt.cpp
#include "spigolo/gauss_map/adapt.h"

#include <algorithm>
#include <cmath>

#include "spigolo/core/parallel.h"

namespace spigolo {
namespace {

constexpr std::size_t grain = 256;  // points
constexpr std::uint8_t max_steps = 250;
constexpr std::size_t test_grain = 32;  // candidates: each costs a clustering

// Test of point i with the first k of its neighbors.
FeatureTest test_at(std::span<const Vec3> points, std::span<const std::uint32_t> neighbors,
                    std::size_t i, const FeatureTestOptions& options, FeatureTestScratch& scratch) {
  scratch.neighbors.clear();
  for (const std::uint32_t j : neighbors) scratch.neighbors.push_back(points[j]);
  return test_point(points[i], scratch.neighbors, options, scratch);
}

std::size_t count(const std::vector<FeatureTest>& tests, FeatureVerdict verdict) {
  return static_cast<std::size_t>(std::count_if(
      tests.begin(), tests.end(), [&](const FeatureTest& t) { return t.verdict == verdict; }));
}

class Adaptation {
 public:
  Adaptation(std::span<const Vec3> points, const Neighborhoods& neighborhoods,
             const AdaptOptions& options, GaussMapFeatures& features)
      : points_(points),
        neighborhoods_(neighborhoods),
        options_(options),
        features_(features),
        k_(std::min(options.k, neighborhoods.k)) {
    for (std::uint32_t i = 0; i < points.size(); ++i)
      if (is_sharp(i)) candidates_.push_back(i);
    wanted_.assign(points.size(), 0);
    while (most_steps_ < max_steps && k_after(most_steps_) > options_.min_k &&
           sigma_after(most_steps_) < options_.max_sigma)
      ++most_steps_;
  }

  // One round on a snapshot of the flags; false when no neighborhood is overrated any more.
  bool round(const Job& job) {
    raise_in_crowded_neighborhoods(job);
    std::vector<std::uint32_t> raised;
    for (const std::uint32_t c : candidates_)
      if (wanted_[c] > features_.steps[c]) raised.push_back(c);
    parallel_for(job, "", raised.size(), test_grain, [&](std::size_t begin, std::size_t end) {
      FeatureTestScratch scratch;
      for (std::size_t r = begin; r < end; ++r) retest(raised[r], scratch);
    });
    std::erase_if(candidates_, [&](std::uint32_t c) { return !is_sharp(c); });
    return !raised.empty();
  }

 private:
  bool is_sharp(std::uint32_t i) const {
    return features_.test[i].verdict == FeatureVerdict::sharp;
  }
  std::size_t k_after(std::uint8_t steps) const {
    return std::max(std::min(options_.min_k, k_), k_ - std::min<std::size_t>(steps, k_));
  }
  double sigma_after(std::uint8_t steps) const {
    return std::min(options_.max_sigma,
                    options_.test.sigma * std::pow(options_.sigma_growth, steps));
  }

  bool crowded(std::uint32_t c) const {
    const auto row = neighborhoods_.of(c).first(k_after(features_.steps[c]));
    const auto flagged = std::count_if(row.begin(), row.end(), [&](auto j) { return is_sharp(j); });
    return static_cast<double>(flagged) >= options_.crowded * static_cast<double>(row.size());
  }

  // In order of the candidates, and the maximum counts: no race, no dependence on their order.
  void raise_in_crowded_neighborhoods(const Job& job) {
    std::vector<std::uint8_t> is_crowded(candidates_.size());
    parallel_for(job, "", candidates_.size(), grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t c = begin; c < end; ++c)
        is_crowded[c] = features_.steps[candidates_[c]] < most_steps_ && crowded(candidates_[c]);
    });
    for (std::size_t c = 0; c < candidates_.size(); ++c) {
      if (!is_crowded[c]) continue;
      const std::uint32_t i = candidates_[c];
      const auto raised = static_cast<std::uint8_t>(features_.steps[i] + 1);
      wanted_[i] = std::max(wanted_[i], raised);
      for (const std::uint32_t j : neighborhoods_.of(i).first(k_after(features_.steps[i])))
        if (is_sharp(j)) wanted_[j] = std::max(wanted_[j], raised);
    }
  }

  void retest(std::uint32_t c, FeatureTestScratch& scratch) {
    features_.steps[c] = wanted_[c];
    FeatureTestOptions test = options_.test;
    test.sigma = sigma_after(wanted_[c]);
    features_.test[c] =
        test_at(points_, neighborhoods_.of(c).first(k_after(wanted_[c])), c, test, scratch);
  }

  std::span<const Vec3> points_;
  const Neighborhoods& neighborhoods_;
  const AdaptOptions& options_;
  GaussMapFeatures& features_;
  std::size_t k_;
  std::vector<std::uint32_t> candidates_;
  std::vector<std::uint8_t> wanted_;
  std::uint8_t most_steps_ = 0;
};

}  // namespace

GaussMapFeatures detect_global(std::span<const Vec3> points, const Neighborhoods& neighborhoods,
                               std::size_t k, const FeatureTestOptions& options, const Job& job) {
  GaussMapFeatures features;
  features.test.resize(points.size());
  features.steps.assign(points.size(), 0);
  k = std::min(k, neighborhoods.k);
  if (k > 0) {
    parallel_for(job, "detect", points.size(), grain, [&](std::size_t begin, std::size_t end) {
      FeatureTestScratch scratch;
      for (std::size_t i = begin; i < end; ++i)
        features.test[i] = test_at(points, neighborhoods.of(i).first(k), i, options, scratch);
    });
  }
  features.candidates = count(features.test, FeatureVerdict::sharp);
  features.degenerate = count(features.test, FeatureVerdict::degenerate);
  return features;
}

GaussMapFeatures detect_adaptive(std::span<const Vec3> points, const Neighborhoods& neighborhoods,
                                 const AdaptOptions& options, const Job& job) {
  GaussMapFeatures features = detect_global(points, neighborhoods, options.k, options.test, job);
  Adaptation adaptation(points, neighborhoods, options, features);
  while (adaptation.round(job)) job.check();
  return features;
}

}  // namespace spigolo
