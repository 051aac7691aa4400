// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/rims.h - rims of holes and pins too small to be followed from sample to sample
#pragma once

#include <span>
#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/trace/shape_curve.h"
#include "spigolo/trace/survey.h"

namespace spigolo {

/// Circles of up to four spacings radius that marks in one plane make, where nothing scatters.
/// Their centre and radius are those of the round wall that stands on the plane, if there is one.
/// marks: those no other curve accounts for. The drafts' members are marks.
std::vector<CurveDraft> find_rims(std::span<const CreaseSample> marks, const Survey& survey,
                                  const Job& job);

}  // namespace spigolo
