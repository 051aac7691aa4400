// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/detect/methods.h - the methods behind detect(), each from a prepared cloud to labels
#pragma once

#include <cstdint>
#include <vector>

#include "spigolo/detect/detect.h"
#include "spigolo/index/prepared_cloud.h"
#include "spigolo/sheets/sheet_model.h"

namespace spigolo {

/// Thesis chapter 3, local-adaptive or global. Labels in canonical order, crease points relative to
/// the cloud's origin; notes in `result` what was used and seen.
Features features_by_gauss_map(const PreparedCloud& prepared, const DetectOptions& options,
                               const Job& job, Detection& result);

/// The labels of the places that have one; crease points relative to the cloud's origin.
struct PlaceFeatures {
  std::vector<std::uint32_t> row;  // of each place in canonical order; no_point: surface
  Features features;
};

/// The sheet model. May widen the neighborhoods: noise asks for more of them.
PlaceFeatures features_by_sheets(PreparedCloud& prepared, const DetectOptions& options,
                                 const Job& job, Detection& result);

/// The verdicts of a sheet model as labels, in canonical order, crease points relative to the
/// cloud's origin.
Features features_of_model(const SheetModel& model);

}  // namespace spigolo
