// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/go_on.h - without noise: ends that may have strayed start anew from what is sure
#pragma once

#include <span>
#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/trace/shape_curve.h"
#include "spigolo/trace/survey.h"

namespace spigolo {

/// Free ends, and ends where only two meet, are cut back to members that are sure, then go on as
/// far as the cloud is sure of the crease. What was seen on the way.
std::vector<CreaseSample> go_on(const Survey& survey, std::vector<CurveDraft>& drafts,
                                std::span<const CreaseSample> samples, const Job& job);

}  // namespace spigolo
