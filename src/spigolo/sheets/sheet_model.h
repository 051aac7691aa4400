// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/sheet_model.h - what is known of a whole cloud: its own sheets and their verdicts
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/index/kd_tree.h"
#include "spigolo/index/prepared_cloud.h"
#include "spigolo/sheets/own_sheet.h"
#include "spigolo/sheets/sheet_places.h"
#include "spigolo/sheets/verdict.h"

namespace spigolo {

/// Built once for a cloud, then asked at any place (SheetProbe, in spigolo/sheets/sheet_probe.h).
/// All positions are relative to prepared.cloud.origin, all rows in the canonical order.
struct SheetModel {
  PreparedCloud prepared;
  SheetTolerances tolerances;
  std::vector<Sheet> own;     // the sheet each point lies on
  VerdictRows verdicts;       // what crease passes each point
  bool labels_given = false;  // the verdicts' edges are given ones, not our own
  std::vector<char> plain;    // 1: nothing but its own sheet anywhere near; empty: not looked at
  SheetPlaces places;         // where the sheets are separated; empty: not looked at

  std::span<const Vec3> points() const { return prepared.cloud.points; }
  std::size_t size() const { return prepared.cloud.size(); }
};

/// Takes over a prepared cloud; may widen its neighborhoods, since noise asks for more of them.
SheetModel build_sheet_model(PreparedCloud prepared, const SheetOptions& options = {},
                             const Job& job = {});

/// Fills `plain`, which spares the looks at most places the search for further sheets.
void note_plain_places(SheetModel& model, const Job& job = {});

}  // namespace spigolo
