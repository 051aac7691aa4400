// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/shape_curve.h - the final form of a curve: straight, round or a spline
#pragma once

#include <optional>
#include <variant>

#include "spigolo/core/feature_curves.h"
#include "spigolo/trace/guide.h"
#include "spigolo/trace/local_fit.h"
#include "spigolo/trace/recognize.h"

namespace spigolo {

/// Lengths in spacings.
struct ShapeTolerances {
  double shape = 0.03;   // a curve this close to a line or circle is one
  double spline = 0.02;  // between a spline and the curve it stands for
  double window = 3;     // of local fits along the curve, to both sides
};

/// One curve on its way from samples to its final form.
struct CurveDraft {
  Guide guide;
  std::array<int, 2> junction = {no_junction, no_junction};
  bool bridged = false;
  std::vector<Member> members;
  std::vector<Station> stations;
  std::variant<std::monostate, LineFit, CircleFit> form;  // what it was recognised as
};

/// Recognises lines and circles among its members.
void recognize(CurveDraft& draft, std::span<const CreaseSample> samples,
               const ShapeTolerances& tolerances);

/// How a draft leaves its first (side 0) or last place: outward, as a chain end does.
LocalCurve end_model(const CurveDraft& draft, int side, std::span<const CreaseSample> samples,
                     const ShapeTolerances& tolerances);

/// The final curve, from corner to corner; junctions: their final places.
FeatureCurve finish(const CurveDraft& draft, std::span<const Vec3> junctions,
                    std::span<const CreaseSample> samples, const ShapeTolerances& tolerances);

}  // namespace spigolo
