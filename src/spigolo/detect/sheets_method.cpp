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

}  // namespace

Features features_of_model(const SheetModel& model) {
  const std::vector<SheetVerdict>& verdicts = model.verdicts;
  Features features;
  features.assign_surface(verdicts.size());
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    const SheetVerdict& verdict = verdicts[i];
    if (verdict.kind == PointKind::surface) continue;
    features.kind[i] = verdict.kind;
    features.angle[i] = verdict.deviation;
    features.strength[i] = static_cast<float>(verdict.strength);
    features.crease_point[i] = verdict.crease_point;
    features.direction[i] = verdict.direction;
    features.sheets[i] = verdict.sheets;
    features.convex[i] = verdict.convex;
  }
  return features;
}

Features features_by_sheets(PreparedCloud& prepared, const DetectOptions& options, const Job& job,
                            Detection& result) {
  SheetModel model = build_sheet_model(std::move(prepared), {options.sensitivity}, job);
  prepared = std::move(model.prepared);
  result.k = neighbors_at_hand(prepared, model.tolerances.k, result.warnings);
  result.candidates = parallel_count(job, model.verdicts.size(), grain, [&](std::size_t i) {
    return model.verdicts[i].kind != PointKind::surface;
  });
  // Before the labels take their room.
  std::vector<Sheet>().swap(model.own);
  prepared.neighborhoods = {};
  return features_of_model(model);
}

}  // namespace spigolo
