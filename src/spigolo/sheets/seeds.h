// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/seeds.h - first guess of the sheets that pass by a place
#pragma once

#include <vector>

#include "spigolo/sheets/heights.h"
#include "spigolo/sheets/sheet_model.h"
#include "spigolo/sheets/sheet_region.h"

namespace spigolo {

/// Greedily from the points' own sheets: the nearest point's one first, then whichever explains
/// most of what is left. Keeps its memory between regions: one for each thread. The model must
/// outlive it.
class SheetSeeder {
 public:
  explicit SheetSeeder(const SheetModel& model);

  /// Sets the sheets of a region whose points are known, and their labels.
  void seed(SheetRegion& region);

 private:
  const Sheet* find_next(const SheetRegion& region);
  double gain_of(const Sheet& sheet, double least);

  const SheetModel& model_;
  SheetTrust trust_;
  std::vector<Vec3> sample_;         // points that are on no sheet yet, some of them
  std::vector<double> explained_;    // how well, by one sheet
  std::vector<const Sheet*> tried_;  // in this round
};

}  // namespace spigolo
