// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/verdict.h - does a crease pass this point?
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "spigolo/core/features.h"
#include "spigolo/core/job.h"
#include "spigolo/index/neighborhoods.h"
#include "spigolo/index/spacing.h"
#include "spigolo/sheets/cover.h"
#include "spigolo/sheets/crease.h"
#include "spigolo/sheets/verdict_rows.h"

namespace spigolo {

struct SheetOptions {
  double sensitivity = 0.5;  // 0 to 1: left fewer bends taken for edges, right more obtuse edges
};

/// [rad] least deviation of an edge: 25 degrees at sensitivity 0, 8 at 0.5, 6 at 1.
double least_deviation(double sensitivity);

/// Verdict on members[0] from the sheets of its neighborhood: an edge if two of them cross within
/// 0.66 spacings of it (1.3 with noise: then it is a proposal, see agree_on_creases), each ends
/// there and the deviation is what the sensitivity asks for; a corner if three meet close by; a
/// border if its own sheet ends there and no other begins.
SheetVerdict judge_point(std::span<const Vec3> points, std::span<const Sheet> sheets,
                         std::span<const std::uint32_t> members, const SheetTolerances& tolerances,
                         const SheetOptions& options);

/// Whether the own sheet of members[0] ends at this very point, though the surface goes on: see
/// find_rim. Without noise.
bool ends_at(std::span<const Vec3> points, std::span<const Sheet> sheets,
             std::span<const std::uint32_t> members, const SheetTolerances& tolerances,
             const SheetOptions& options);

/// All points, from their own sheets. neighborhoods need max(20, sheet_tolerances(noise).k)
/// neighbors a row. With noise these are proposals.
VerdictRows judge_points(std::span<const Vec3> points, const Neighborhoods& neighborhoods,
                         std::span<const Sheet> sheets, const SheetTolerances& tolerances,
                         const SheetOptions& options, const Job& job = {});

/// Drops what the neighbors' verdicts speak against, all from one snapshot: edges and borders that
/// stand alone, and of two points beside each other on an edge the one clearly farther from it;
/// how close beside each other shrinks with the noise [spacings], down to never.
void clean_verdicts(std::span<const Vec3> points, const Neighborhoods& neighborhoods,
                    const Spacing& spacing, const SheetTolerances& tolerances,
                    VerdictRows& verdicts, const Job& job = {});

}  // namespace spigolo
