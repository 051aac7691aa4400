// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/meeting.h - how many sheets meet at a corner, whatever its valence
#pragma once

#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/sheets/sheet_cloud.h"
#include "spigolo/sheets/verdict.h"

namespace spigolo {

/// Counts the sheets that meet at each corner from a wider look than the one that found it: facets
/// of a narrow pyramid have but two or three points among the nearest neighbors of its apex. A
/// point where creases of three directions run in, and four sheets or more have a common point
/// within 0.9 spacings, becomes a corner. For clouds without noise; tips of cones come first and
/// are left as they are.
void count_meeting_sheets(const SheetCloud& cloud, VerdictRows& verdicts, const Job& job = {});

}  // namespace spigolo
