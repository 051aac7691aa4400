// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/gauss_map/adapt.h - global and local-adaptive detection by the Gauss map (thesis §3.4,
// §3.6)
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/gauss_map/feature_test.h"
#include "spigolo/index/neighborhoods.h"

namespace spigolo {

struct AdaptOptions {
  std::size_t k = 20;  // neighbors of the first pass, at most those of the neighborhoods and 64
  FeatureTestOptions test;  // of the first pass: sigma 0.1 finds too many candidates on purpose
  double crowded = 0.30;    // share of candidates in a neighborhood from which on it is overrated
  double sigma_growth = 1.10;  // factor a step
  double max_sigma = 1.2;      // [rad]
  std::size_t min_k = 8;       // k falls by one a step, down to this
};

/// What the Gauss map says of every point, in canonical order.
struct GaussMapFeatures {
  std::vector<FeatureTest> test;    // the last one each point was put to
  std::vector<std::uint8_t> steps;  // how often its parameters were adapted; 0 if never
  std::size_t candidates = 0;       // sharp after the first pass
  std::size_t degenerate = 0;       // neighborhoods that span no surface
};

/// The global method (§3.4): test_point with the first k neighbors (at most 64) for all points.
GaussMapFeatures detect_global(std::span<const Vec3> points, const Neighborhoods& neighborhoods,
                               std::size_t k, const FeatureTestOptions& options,
                               const Job& job = {});

/// The local-adaptive method (§3.6): where 30 % of a candidate's neighborhood are candidates, sigma
/// grows and k shrinks for it and for the candidates in its neighborhood, which are tested again.
/// The thesis removes candidates while it walks through them, so its result depends on their order.
/// Here every round reads the flags of the round before and removes together; a candidate in
/// several overrated neighborhoods takes the largest of their steps. Only candidates are ever
/// removed: the features are a subset of those of the global method.
GaussMapFeatures detect_adaptive(std::span<const Vec3> points, const Neighborhoods& neighborhoods,
                                 const AdaptOptions& options, const Job& job = {});

}  // namespace spigolo
