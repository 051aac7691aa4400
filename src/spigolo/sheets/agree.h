// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/agree.h - with noise, what the neighbors make of a crease counts more than one fit
#pragma once

#include <span>
#include <vector>

#include "spigolo/index/neighborhoods.h"
#include "spigolo/index/spacing.h"
#include "spigolo/sheets/verdict.h"

namespace spigolo {

/// Each edge among `proposals` stands for a piece of straight crease, however far from its point.
/// Every point takes the mean of those in its neighborhood that pass close to each other, if
/// enough of them agree and outnumber the bends, of several such creases the nearest one: the
/// position becomes as certain as several fits.
/// How near that comes to the point, within two spacings, is asked later
/// (drop_passed_by). Corners and borders stay. All
/// from one snapshot.
VerdictRows agree_on_creases(std::span<const Vec3> points, const Neighborhoods& neighborhoods,
                             const Spacing& spacing, const VerdictRows& proposals,
                             const Job& job = {});

}  // namespace spigolo
