// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/tips.h - the apex of a cone: sharp, but on no crease
#pragma once

#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/sheets/own_sheet.h"
#include "spigolo/sheets/sheet_cloud.h"
#include "spigolo/sheets/verdict.h"

namespace spigolo {

/// Where the tangent planes of all sheets around meet in one point and their normals fan out evenly
/// (a pyramid's come in bundles), there is a tip: the samples within 0.66 spacings of it, or the
/// nearest one within 1, become tips, and the creases that the cone's own curvature feigned close
/// to it go. deviation: 180 degrees less the opening angle. Not looked for where noise hides the
/// fan (0.15 spacings and more).
void find_tips(const SheetCloud& cloud, const SheetTolerances& tolerances, VerdictRows& verdicts,
               const Job& job = {});

}  // namespace spigolo
