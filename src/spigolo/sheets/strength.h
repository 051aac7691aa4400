// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/strength.h - how likely is a verdict right?
#pragma once

#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/sheets/own_sheet.h"
#include "spigolo/sheets/sheet_cloud.h"
#include "spigolo/sheets/verdict.h"

namespace spigolo {

/// Sets the strength of edges and corners to the share of such points that are right: a logistic
/// model of the noise, the distance to the crease, the angle and how many neighbors are sharp too,
/// fitted to constructed shapes (docs/detection.md says which, and how it holds on others).
void rate_verdicts(const SheetCloud& cloud, const SheetTolerances& tolerances,
                   VerdictRows& verdicts, const Job& job = {});

}  // namespace spigolo
