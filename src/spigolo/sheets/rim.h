// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/rim.h - where a sheet ends though the surface goes on
#pragma once

#include <array>
#include <optional>
#include <span>

#include "spigolo/core/job.h"
#include "spigolo/sheets/cover.h"
#include "spigolo/sheets/sheet_cloud.h"
#include "spigolo/sheets/verdict.h"

namespace spigolo {

/// An edge known by one of its sides only: the next piece of surface is too narrow or too tightly
/// bent to have a sheet of its own (the wall of a low step, a chamfer of two rows, a thin plate's
/// border, a small hole).
struct Rim {
  Vec3 direction;            // unit, along the end of the sheet
  std::array<Vec3, 2> into;  // unit, square to it: into the sheet; to where the surface goes on
  double deviation = 0;      // [rad] from flat
};

/// Whether members[0] is the last point of its own sheet, cover.sheet[0], on one side: no other
/// point of the sheet lies there, those that are near lie steeply off it and are not all the far
/// side of a thin wall. For clouds without noise. Nothing where that side is empty (a border), the
/// surface only bends, or the deviation is less than `least_deviation` [rad].
std::optional<Rim> find_rim(std::span<const Vec3> points, std::span<const Sheet> sheets,
                            std::span<const std::uint32_t> members, const SheetCover& cover,
                            double least_deviation);

/// Drops the rims that are only the luck of the samples: where another sheet within three spacings
/// runs past the supposed end, as the far wall of a wedge shows through a gap in the near one.
void drop_chance_rims(const SheetCloud& cloud, VerdictRows& verdicts, const Job& job = {});

}  // namespace spigolo
