// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/pipeline/curve_step.h - a network of feature curves as STEP
#pragma once

#include <string>

#include "spigolo/core/feature_curves.h"
#include "spigolo/io/curve_writers.h"

namespace spigolo {

/// Throws UsageError for feet, which STEP files of ours have no word for.
void check_step_unit(LengthUnit unit);

/// Lines as lines, circles and arcs as such, all else as B-splines, corners as points. Without a
/// unit the file says mm. An empty network gives a file without entities. Throws UsageError as
/// check_step_unit does.
std::string step_text(const FeatureCurves& network, LengthUnit unit);

}  // namespace spigolo
