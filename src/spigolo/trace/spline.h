// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/spline.h - cubic B-splines through the points of a curve, and their values
#pragma once

#include <span>

#include "spigolo/core/feature_curves.h"

namespace spigolo {

/// Least squares over chord length, from the first point exactly to the last; knots are added where
/// the points are farther off than tolerance, until none is or a span holds a single point. closed:
/// on from the last point to the first, smoothly. At least two points, three if closed.
CurveSpline fit_spline(std::span<const Vec3> points, bool closed, double tolerance);

/// The point at t, clamped to the range of the knots (de Boor).
Vec3 value(const CurveSpline& spline, double t);

/// First and last parameter.
double first_parameter(const CurveSpline& spline);
double last_parameter(const CurveSpline& spline);

/// The same curve with one more knot at t (Boehm); t inside the range.
void insert_knot(CurveSpline& spline, double t);

}  // namespace spigolo
