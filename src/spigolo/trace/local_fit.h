// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/local_fit.h - a short piece of a space curve through scattered samples
#pragma once

#include <span>

#include "spigolo/core/geometry.h"

namespace spigolo {

/// x(u) = place + u tangent + u^2 / 2 bend, with u along the unit tangent and bend across it.
struct LocalCurve {
  Vec3 place, tangent, bend;
  double residual = 0;  // robust rms distance of the samples
  int support = 0;      // samples that count at least half; 0: there was nothing to fit

  Vec3 at(double u) const { return place + tangent * u + bend * (u * u / 2); }
  Vec3 along(double u) const { return normalized(tangent + bend * u); }
};

/// Robust least squares (Cauchy weights, scale from the median residual but at least `exact`)
/// across `direction` at `origin`. degree 1: straight; 2: bent, if there are four samples or more
/// on both sides of the origin or far enough apart to tell. The sign of the tangent is that of the
/// direction.
struct LocalFitOptions {
  int degree = 2;
  double exact = 1e-5;  // residuals below this are none
};
LocalCurve fit_local_curve(std::span<const Vec3> samples, const Vec3& origin, const Vec3& direction,
                           const LocalFitOptions& options = {});

/// A place and the direction of a curve there, unit.
struct CurveEnd {
  Vec3 place, along;
};

/// The cubic between two places with these directions, t in [0, 1]; its speed at the ends is that
/// of the best cubic for an arc of a circle.
Vec3 cubic_between(const CurveEnd& a, const CurveEnd& b, double t);

}  // namespace spigolo
