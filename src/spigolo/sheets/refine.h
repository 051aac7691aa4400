// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/refine.h - with noise, the verdicts are given again by sheets fitted more widely
#pragma once

#include "spigolo/core/job.h"
#include "spigolo/sheets/sheet_model.h"

namespace spigolo {

/// The verdicts of a noisy cloud say near which points there may be a crease. There the sheets are
/// separated and fitted again, with weights and more points than the first look had (SheetProbe);
/// their crease, if within 2.5 spacings, becomes the point's proposal (see agree_on_creases): the
/// position gets twice as certain. A crease narrower than those wide fits can see stays as it was.
void refine_creases(SheetModel& model, const SheetOptions& options, const Job& job = {});

}  // namespace spigolo
