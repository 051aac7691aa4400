// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/joints.h - with noise, corners are where agreed creases run together
#pragma once

#include <span>
#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/index/neighborhoods.h"
#include "spigolo/index/spacing.h"
#include "spigolo/sheets/verdict.h"

namespace spigolo {

/// A point that lies within 0.9 spacings (0.6 if no crease passes it) of the place where agreed
/// creases of three directions or more meet, each three points strong, becomes a corner there: the
/// sheets of one neighborhood tell less of that place than all the creases around it. Creases of
/// one plane are no corner but a curve that bends. All from one snapshot.
void join_creases(std::span<const Vec3> points, const Neighborhoods& neighborhoods,
                  const Spacing& spacing, VerdictRows& verdicts, const Job& job = {});

}  // namespace spigolo
