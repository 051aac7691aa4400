// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/common.cpp
#include "common.h"

namespace spigolo::bench {
namespace {

std::vector<Vec3> chosen(const std::vector<Vec3>& points, const std::vector<std::uint8_t>& flags) {
  std::vector<Vec3> result;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (flags[i]) result.push_back(points[i]);
  return result;
}

}  // namespace

DetectOptions thesis_method() {
  DetectOptions options;
  options.method = DetectMethod::gauss_map;
  return options;
}

Scored detect_and_score(const SynthCloud& synth, const DetectOptions& options) {
  Scored scored;
  scored.detection = detect(synth.cloud.points, options);
  const std::vector<std::uint8_t> flags = sharp_flags(scored.detection.features);
  const FeatureTruth truth = read_truth(synth.cloud, synth.spacing, synth.lattice);
  scored.thin = classify(flags, truth, Scoring::thin);
  scored.tolerant = classify(flags, truth, Scoring::tolerant);
  const std::vector<Vec3> real = chosen(synth.exact, truth.feature);
  if (!real.empty()) scored.deviation = feature_deviation(chosen(synth.cloud.points, flags), real);
  return scored;
}

}  // namespace spigolo::bench
