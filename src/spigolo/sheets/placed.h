// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/placed.h - clouds whose samples were put on the edges, as vertices of meshes are
#pragma once

#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/sheets/sheet_cloud.h"
#include "spigolo/sheets/verdict.h"

namespace spigolo {

/// Whether two in five marked points lie right on their creases: samples were put there then.
bool is_placed(const SheetCloud& cloud, const VerdictRows& verdicts, const Job& job = {});

/// In such a cloud all edges carry samples, and a crease that runs between them is none: the
/// roundings of meshes feign those. Marks off their crease go, but at the end of a sheet (a rim:
/// both rows of a chamfer, say). And samples right on a crease, which need less evidence than
/// those beside one, are marked where judge_points could not (find_placed_crease).
void judge_placed(const SheetCloud& cloud, const SheetTolerances& tolerances,
                  const SheetOptions& options, VerdictRows& verdicts, const Job& job = {});

}  // namespace spigolo
