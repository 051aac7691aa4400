// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/layers.h - the curves of one kind: edges, small rims, borders
#pragma once

#include <span>
#include <vector>

#include "spigolo/core/feature_curves.h"
#include "spigolo/core/job.h"
#include "spigolo/trace/crease_samples.h"
#include "spigolo/trace/shape_curve.h"
#include "spigolo/trace/survey.h"

namespace spigolo {

struct Layer {
  CurveKind kind = CurveKind::edge;
  std::vector<CreaseSample> samples;
  double scatter = 0;
  ShapeTolerances tolerances;
};

/// Each adds its curves and corners to the network. hints: where single points saw three sheets.
void trace_edges(Layer layer, const Survey& survey, std::span<const Vec3> hints, const Job& job,
                 FeatureCurves& network);

/// From marks that no curve of the network accounts for.
void trace_rims(Layer layer, std::span<const CreaseSample> marks, const Survey& survey,
                const Job& job, FeatureCurves& network);

void trace_borders(const Layer& layer, const Job& job, FeatureCurves& network);

}  // namespace spigolo
