// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/sheet_probe.h - looks at the sheet model of a cloud at any place
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "spigolo/index/kd_tree.h"
#include "spigolo/sheets/local_sheets.h"
#include "spigolo/sheets/separate.h"
#include "spigolo/sheets/sheet_model.h"
#include "spigolo/sheets/sheet_region.h"

namespace spigolo {

ProbeReach probe_reach(double noise);

/// Points within three h or so of a place: what a look with that smoothing needs.
std::size_t points_for(double smoothing);

/// Keeps its memory between looks: one for each thread. The model and the tree must outlive it.
/// If the model has places, the sheets were sought there, and a look fits those of the nearest
/// place: faster, and the same sheets for neighboring queries.
class SheetProbe {
 public:
  SheetProbe(const SheetModel& model, const KdTree& tree, const ProbeReach& reach);

  /// The sheets near `center` (relative to the cloud's origin), fitted with weights around it.
  /// Valid until the next look. count is 0 where there is no data to fit anything to.
  const LocalSheets& look(const Vec3& center);

  /// The same at a point of the model without places, whose reach.k - 1 neighbors are known.
  const LocalSheets& look_at(std::uint32_t point, std::span<const std::uint32_t> neighbors);

  double away() const { return away_; }        // of the last look's center from the nearest point
  double spacing() const { return spacing_; }  // at the last place
  /// Of the point nearest to the last look's center.
  const Sheet& own_sheet() const { return model_.own[nearest_.front().index]; }
  /// Place whose sheets the last look used, and the one a look at x would use.
  std::uint32_t place() const { return place_; }
  std::uint32_t place_at(const Vec3& x);
  /// [spacings] the center of a look may be off without changing what it finds.
  double slack() const { return slack_; }

 private:
  void seek(bool plain);
  const PartedRegion& region_of(std::uint32_t place);

  const SheetModel& model_;
  const KdTree& tree_;
  ProbeReach reach_, wide_;  // wide_: at a place
  SheetSeparator separator_;
  SheetRegion region_;  // of the last search
  LocalSheets fitted_;  // of the last look at a known place
  double spacing_ = 1, away_ = 0, slack_ = 0;
  std::uint32_t place_ = no_point;
  std::vector<Neighbor> nearest_;
  std::vector<double> weights_;
  std::unordered_map<std::uint32_t, PartedRegion> known_;  // the last places, by number
};

}  // namespace spigolo
