// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/stages.h - the noise-free detection, stage by stage
#pragma once

#include <array>
#include <span>

#include "spigolo/core/geometry.h"
#include "spigolo/core/job.h"

namespace spigolo::bench {

inline constexpr std::array<const char*, 10> stage_names = {
    "order", "tree", "neighbors", "spacing, noise", "own sheets",
    "judge", "gaps", "tips",      "strength",       "convexity"};

/// CPU seconds of each stage on a cloud without noise, by the calls that detect() makes.
std::array<double, stage_names.size()> stage_seconds(std::span<const Vec3> points, const Job& job);

}  // namespace spigolo::bench
