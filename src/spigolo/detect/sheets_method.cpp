// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/detect/sheets_method.cpp - the sheet model
#include <utility>

#include "spigolo/core/parallel.h"
#include "spigolo/detect/methods.h"
#include "spigolo/sheets/sheet_model.h"

namespace spigolo {
namespace {

constexpr std::size_t grain = 1 << 14;

void set_row(Features& features, std::size_t row, const SheetVerdict& verdict) {
  features.kind[row] = verdict.kind;
  features.angle[row] = verdict.deviation;
  features.strength[row] = static_cast<float>(verdict.strength);
  features.crease_point[row] = verdict.crease_point;
  features.direction[row] = verdict.direction;
  features.sheets[row] = verdict.sheets;
  features.convex[row] = verdict.convex;
}

// Few places are marked: the others need no row.
PlaceFeatures marked_places(const VerdictRows& verdicts, const Job& job) {
  const auto marked = parallel_select(job, verdicts.size(), grain, [&](std::size_t i) {
    return verdicts[i].kind != PointKind::surface;
  });
  PlaceFeatures found;
  found.row.assign(verdicts.size(), no_point);
  found.features.assign_surface(marked.size());
  for (std::uint32_t m = 0; m < marked.size(); ++m) {
    found.row[marked[m]] = m;
    set_row(found.features, m, verdicts[marked[m]]);
  }
  return found;
}

}  // namespace

Features features_of_model(const SheetModel& model) {
  const VerdictRows& verdicts = model.verdicts;
  Features features;
  features.assign_surface(verdicts.size());
  for (std::size_t i = 0; i < verdicts.size(); ++i)
    if (verdicts[i].kind != PointKind::surface) set_row(features, i, verdicts[i]);
  return features;
}

PlaceFeatures features_by_sheets(PreparedCloud& prepared, const DetectOptions& options,
                                 const Job& job, Detection& result) {
  SheetModel model = build_sheet_model(std::move(prepared), {options.sensitivity}, job);
  prepared = std::move(model.prepared);
  result.k = neighbors_at_hand(prepared, model.tolerances.k, result.warnings);
  std::vector<Sheet>().swap(model.own);  // before the labels take their room
  PlaceFeatures found = marked_places(model.verdicts, job);
  result.candidates = found.features.size();
  return found;
}

}  // namespace spigolo
