// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/cad/nurbs_curve.h - NURBS curves as plain data (thesis §2.4)
#pragma once

#include <array>
#include <span>
#include <vector>

#include "spigolo/core/geometry.h"

namespace spigolo {

inline constexpr int highest_degree = 25;  // as in OpenCASCADE

/// (2.22). knots has poles.size() + degree + 1 entries, never descending; the curve runs over
/// [knots[degree], knots[poles.size()]]. A closed curve repeats its first point at its end.
struct NurbsCurve {
  int degree = 3;
  std::vector<double> knots;
  std::vector<Vec3> poles;
  std::vector<double> weights;  // one a pole, positive; empty: all 1
};

/// Throws Error unless the arrays match, knots ascend over a range that is not empty, no knot
/// inside it is there more than `degree` times, weights are positive and all is finite.
void validate(const NurbsCurve& curve);

/// Point of the curve; t outside its range is moved to the nearer end.
Vec3 point_at(const NurbsCurve& curve, double t);

struct CurvePoint {
  Vec3 point, derivative;
};
CurvePoint evaluate(const NurbsCurve& curve, double t);

/// The whole circle, exactly: quadratic, nine poles. x, y: unit and perpendicular to each other;
/// starts at center + radius x and turns towards y.
NurbsCurve nurbs_circle(const Vec3& center, const Vec3& x, const Vec3& y, double radius);

/// The degree + 1 basis functions (2.23) that are not zero at t, and their derivatives:
/// value[i] belongs to pole first + i.
struct BasisFunctions {
  std::size_t first = 0;
  std::array<double, highest_degree + 1> value{}, derivative{};
};
BasisFunctions basis_functions(std::span<const double> knots, int degree, double t);

/// The range of a knot vector.
double first_parameter(std::span<const double> knots, int degree);
double last_parameter(std::span<const double> knots, int degree);

/// Throws Error, naming `what`, unless the knots suit that many poles.
void validate_knots(std::span<const double> knots, int degree, std::size_t poles, const char* what);

}  // namespace spigolo
