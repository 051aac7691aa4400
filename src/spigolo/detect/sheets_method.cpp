// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/detect/sheets_method.cpp - the sheet model
#include <algorithm>
#include <utility>

#include "spigolo/detect/methods.h"
#include "spigolo/sheets/sheet_model.h"

namespace spigolo {
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
  result.candidates = static_cast<std::size_t>(
      std::count_if(model.verdicts.begin(), model.verdicts.end(),
                    [](const SheetVerdict& v) { return v.kind != PointKind::surface; }));
  return features_of_model(model);
}

}  // namespace spigolo
