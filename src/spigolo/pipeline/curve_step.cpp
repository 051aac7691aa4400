// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/pipeline/curve_step.cpp
#include "spigolo/pipeline/curve_step.h"

#include "spigolo/cad/step_writer.h"
#include "spigolo/core/error.h"
#include "spigolo/io/curve_tables.h"

namespace spigolo {
namespace {

// Part 21 allows a data section without instances.
constexpr const char* empty_file =
    "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION(('no feature curves'),'2;1');\n"
    "FILE_NAME('','',(''),(''),'spigolo','spigolo','');\n"
    "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\nDATA;\nENDSEC;\n"
    "END-ISO-10303-21;\n";

std::string step_unit(LengthUnit unit) {
  return unit == LengthUnit::none ? "mm" : unit == LengthUnit::inch ? "inch" : unit_name(unit);
}

CadCurve cad_curve(const FeatureCurve& curve) {
  if (curve.shape == CurveShape::line) return CadLine{curve.points.front(), curve.points.back()};
  if (curve.shape == CurveShape::spline) {
    RationalSpline spline = rational_spline(curve);
    return NurbsCurve{spline.degree, std::move(spline.knots), std::move(spline.poles), {}};
  }
  const Vec3 x = normalized(curve.points.front() - curve.center);
  return CadArc{curve.center, x, cross(curve.axis, x), curve.radius, 0, sweep_of(curve)};
}

}  // namespace

void check_step_unit(LengthUnit unit) {
  if (unit == LengthUnit::foot) throw UsageError("STEP files take --unit mm, cm, m or in, not ft");
}

std::string step_text(const FeatureCurves& network, LengthUnit unit) {
  check_step_unit(unit);
  if (network.curves.empty() && network.corners.empty()) return empty_file;
  StepContent content;
  content.name = "feature curves";
  for (const FeatureCurve& curve : network.curves) content.curves.push_back(cad_curve(curve));
  for (const FeatureCorner& corner : network.corners) content.points.push_back(corner.position);
  return step_text(content, step_unit(unit));
}

}  // namespace spigolo
