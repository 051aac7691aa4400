// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/cover.h - which sheets pass through a neighborhood?
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <span>
#include <vector>

#include "spigolo/sheets/own_sheet.h"

namespace spigolo {

inline constexpr std::size_t max_cover_points = 128;
using PointSet = std::bitset<max_cover_points>;

/// The sheets that explain a neighborhood, the point's own one first, each with the neighbors on it
/// (a point near a crease lies on several).
struct SheetCover {
  static constexpr std::size_t most = 5;
  std::array<const Sheet*, most> sheet{};
  std::array<PointSet, most> on;
  std::size_t count = 0;
  std::size_t unexplained = 0;  // neighbors on none of them
};

/// Whether cover_neighborhood needs no look: no point of a whole sheet that fits so well can be
/// farther from it than the limit. The members must be among the points it was fitted to.
bool explains_all(const Sheet& own, const SheetTolerances& tolerances);

/// Greedily: the point's own sheet, then of the neighbors' own sheets the one that explains most of
/// the neighbors left, until all are explained or none explains three more. Sheets fitted badly
/// explain nothing. members: places in `points` and `sheets`, the point itself first; at most 128.
SheetCover cover_neighborhood(std::span<const Vec3> points, std::span<const Sheet> sheets,
                              std::span<const std::uint32_t> members,
                              const SheetTolerances& tolerances);

}  // namespace spigolo
