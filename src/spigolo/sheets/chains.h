// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/chains.h - with noise, edges that are too short to be more than chance
#pragma once

#include <span>
#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/index/neighborhoods.h"
#include "spigolo/index/spacing.h"
#include "spigolo/sheets/verdict.h"

namespace spigolo {

/// Drops edges and corners that are connected to no more than a few others: with noise above 0.1
/// [spacings] several neighbors may agree by chance, but not along a row of four spacings. Marked
/// points are connected from one to the next among their neighbors, over 2.5 spacings, or 5 along a
/// crease that both name. All from one snapshot.
void drop_short_chains(std::span<const Vec3> points, const Neighborhoods& neighborhoods,
                       const Spacing& spacing, double noise, VerdictRows& verdicts,
                       const Job& job = {});

}  // namespace spigolo
