// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/convexity.h - ridge or valley? Which side of the surface is outside
#pragma once

#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/sheets/own_sheet.h"
#include "spigolo/sheets/sheet_cloud.h"
#include "spigolo/sheets/verdict.h"

namespace spigolo {

/// Fills `convex` of edges and corners. One side is carried from point to point over each sheet and
/// across the creases, surest links first (as Hoppe et al. 1992, but with the sheets themselves and
/// known creases instead of guessed normals); in every connected piece that closes, the volume
/// tells which side is outside. Pieces that do not close have no outside: 0. A corner is convex or
/// concave if all edges around it are.
void note_convexity(const SheetCloud& cloud, const SheetTolerances& tolerances,
                    VerdictRows& verdicts, const Job& job = {});

}  // namespace spigolo
