// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/sheet_places.h - the places of a cloud where its sheets are separated, once for
// all
#pragma once

#include <cstdint>
#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/sheets/local_sheets.h"

namespace spigolo {

class KdTree;
struct SheetModel;

/// How far a look reaches; both grow with the noise.
struct ProbeReach {
  double smoothing = 1.3;  // [spacings] h of the weight exp(-d^2/h^2) around the place
  std::size_t k = 32;      // points looked at, the nearest ones
};

/// The sheets of a place and the look they are fit for, which a thin part may have narrowed.
struct PlaceSheets {
  LocalSheets sheets;
  ProbeReach reach;
  double score = 0;
};

/// Places are points of the cloud; each point belongs to one that is near.
struct SheetPlaces {
  std::vector<std::uint32_t> of_point;  // number of the point's place
  std::vector<std::uint32_t> point;     // of each place
  std::vector<std::uint32_t> known;     // of each place: its entry in `sheets`; no_point: one sheet
  std::vector<PlaceSheets> sheets;
  double noise = 0;  // [spacings] of points about these sheets; 0 where it does not matter

  bool empty() const { return point.empty(); }
};

/// The same look, as far around a query at the rim of a place.
ProbeReach reach_of_places(const ProbeReach& reach);

/// Fills model.places; needs model.plain. By falling spacing, a point near no place becomes one;
/// points belong to the nearest one. So a turned cloud has the same places. Where there may be
/// several sheets they are sought there; with noise each place then tries the sheets that its
/// neighbors have found, and a fold, and keeps what explains its points best.
void separate_places(SheetModel& model, const KdTree& tree, const ProbeReach& reach,
                     const Job& job = {});

}  // namespace spigolo
