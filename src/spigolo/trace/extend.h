// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/extend.h - samples of creases that no point of the cloud was marked for
#pragma once

#include <span>
#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/trace/shape_curve.h"
#include "spigolo/trace/survey.h"

namespace spigolo {

/// What marches from all ends of the chains see, up to places that are known. samples: those the
/// chains were linked from.
std::vector<CreaseSample> march_from_ends(const Survey& survey, std::span<const Chain> chains,
                                          std::span<const CreaseSample> samples, double scatter,
                                          const Job& job);

/// What walks along all curves see: everywhere, or where a curve has no samples of its own.
std::vector<CreaseSample> walk_along(const Survey& survey, std::span<const CurveDraft> drafts,
                                     std::span<const CreaseSample> samples, bool everywhere,
                                     const Job& job);

/// The chains of all drafts; free ends of those recognised as lines or circles go on along them to
/// the first junction, free end or other extension they come to, if that is no farther than a
/// share of their own length.
std::vector<Chain> reach_out(std::span<const CurveDraft> drafts, std::span<const Vec3> junctions,
                             double scatter);

}  // namespace spigolo
