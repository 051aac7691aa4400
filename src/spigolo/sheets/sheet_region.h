// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/sheet_region.h - the points around one place, parted by the sheet they lie on
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "spigolo/index/kd_tree.h"
#include "spigolo/sheets/sheet_model.h"

namespace spigolo {

/// While the sheets are sought.
struct SheetRegion {
  Vec3 center;
  double spacing = 1;              // there
  double smoothing = 1.3;          // [spacings] h of the weight exp(-d^2/h^2)
  std::vector<Neighbor> found;     // points of the cloud, nearest first
  std::vector<Vec3> points;        // the same
  std::vector<std::int8_t> label;  // sheet of each point, -1: none
  LocalSheets sheets;
};

/// The reach.k points of the model nearest to `center`.
void gather_region(const SheetModel& model, const KdTree& tree, const Vec3& center,
                   const ProbeReach& reach, SheetRegion& region);

/// A point of the model and its neighbors, nearest first.
void gather_region(const SheetModel& model, std::uint32_t point,
                   std::span<const std::uint32_t> neighbors, double smoothing, SheetRegion& region);

/// When they are known: points of one sheet side by side, ready to be fitted around any query near
/// the place.
struct PartedRegion {
  Vec3 center;
  double spacing = 1;
  double smoothing = 1.3;  // [spacings]
  double radius = 0;       // of the farthest point
  std::vector<Vec3> points;
  std::vector<double> share;  // of each of them: how likely it is of that sheet
  std::array<std::uint32_t, LocalSheets::most + 1> begin{};  // points of sheet s: begin[s] on
  LocalSheets sheets;                                        // as fitted at the place
};

/// A place that is known to lie on the crease of two sheets: a point of both of them.
struct CreasePin {
  Vec3 place;
  std::array<std::size_t, 2> sheets;
  double weight = 0;  // as so many samples
};

/// noise: [spacings] about the sheets; with any, a point near a crease counts for both sheets, as
/// likely as it is of each. Else its label decides. pins: places added to their sheets.
PartedRegion part(const SheetRegion& region, double noise, std::span<const CreasePin> pins = {});

/// Each sheet fitted anew, the nearer to the query the weightier, by planes where the region has
/// planes. The weight (1 - d^2/R^2)^3 ends within the region, so that it changes smoothly as the
/// query moves. Sheets with too few points near the query stay as they are. `weights` is memory.
void fit_around(const PartedRegion& region, const Vec3& query, double ridge,
                std::vector<double>& weights, LocalSheets& fitted);

}  // namespace spigolo
