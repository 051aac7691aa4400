// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/folds.h - with noise: folds of wide neighborhoods as proposals of creases
#pragma once

#include "spigolo/core/job.h"
#include "spigolo/sheets/sheet_model.h"

namespace spigolo {

/// Looks for a fold (HingeTest) around one point in three, over neighborhoods that grow until what
/// they hold is decided: a larger one sees fainter folds, and knows better where they are. An edge
/// within 2.5 spacings becomes the proposal of the center and of the points around it; a bend takes
/// theirs away; else they stay.
void propose_folds(SheetModel& model, const SheetOptions& options, const Job& job = {});

}  // namespace spigolo
