// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/gaps.h - a point between two on the same crease is on it too
#pragma once

#include <span>
#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/index/neighborhoods.h"
#include "spigolo/index/spacing.h"
#include "spigolo/sheets/verdict.h"

namespace spigolo {

/// A point of smooth surface becomes an edge if two of its neighbors lie on one crease, before and
/// behind it, with directions along the line between them, that line passes within half a spacing
/// of the point, and no edge point is nearer to that place. on_edges: where samples
/// were put on the edges it must pass within a tenth. (The thesis's adaptation only removes.)
/// All from one snapshot.
void fill_gaps(std::span<const Vec3> points, const Neighborhoods& neighborhoods,
               const Spacing& spacing, bool on_edges, VerdictRows& verdicts, const Job& job = {});

}  // namespace spigolo
