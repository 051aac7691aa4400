// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/common.h - one synthetic cloud, detected and scored
#pragma once

#include "spigolo/detect/detect.h"
#include "spigolo/measure/classification.h"
#include "spigolo/synth/synth.h"

namespace spigolo::bench {

struct Scored {
  Detection detection;
  Classification thin, tolerant;
  FeatureDeviation deviation;  // [units of the shape] delta_inf, delta_avg
};

/// The thesis's local-adaptive method with its automatic parameters.
DetectOptions thesis_method();

Scored detect_and_score(const SynthCloud& synth, const DetectOptions& options = {});

}  // namespace spigolo::bench
