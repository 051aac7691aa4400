// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/cad/nurbs_curve.cpp
#include "spigolo/cad/nurbs_curve.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "spigolo/core/error.h"

namespace spigolo {
namespace {

using Row = std::array<double, highest_degree + 1>;

// Index of the knot interval that holds t; the last one that is not empty at the end of the range.
std::size_t find_span(std::span<const double> knots, int degree, double t) {
  const auto p = static_cast<std::size_t>(degree);
  const std::size_t last = knots.size() - p - 1;
  const auto begin = knots.begin() + degree,
             end = knots.begin() + static_cast<std::ptrdiff_t>(last);
  auto span = static_cast<std::size_t>(std::upper_bound(begin, end, t) - knots.begin()) - 1;
  while (span > p && !(knots[span] < knots[span + 1])) --span;
  return span;
}

// One level of the recursion (2.23) for all functions that are not zero in the span: degree k - 1
// in, degree k out.
void raise(std::span<const double> knots, std::size_t span, double t, std::size_t k, Row& value) {
  double carried = 0;
  for (std::size_t j = 0; j < k; ++j) {
    const double left = knots[span + j + 1 - k], right = knots[span + j + 1];
    const double share = value[j] / (right - left);
    value[j] = carried + (right - t) * share;
    carried = (t - left) * share;
  }
  value[k] = carried;
}

// Derivatives of degree p from the values of degree p - 1.
void differentiate(std::span<const double> knots, std::size_t span, std::size_t p, const Row& lower,
                   Row& derivative) {
  double carried = 0;
  for (std::size_t j = 0; j < p; ++j) {
    const double width = knots[span + j + 1] - knots[span + j + 1 - p];
    const double slope = static_cast<double>(p) * lower[j] / width;
    derivative[j] = carried - slope;
    carried = slope;
  }
  derivative[p] = carried;
}

}  // namespace

double first_parameter(std::span<const double> knots, int degree) {
  return knots[static_cast<std::size_t>(degree)];
}

double last_parameter(std::span<const double> knots, int degree) {
  return knots[knots.size() - static_cast<std::size_t>(degree) - 1];
}

BasisFunctions basis_functions(std::span<const double> knots, int degree, double t) {
  t = std::clamp(t, first_parameter(knots, degree), last_parameter(knots, degree));
  const auto p = static_cast<std::size_t>(degree);
  const std::size_t span = find_span(knots, degree, t);
  BasisFunctions basis;
  basis.first = span - p;
  basis.value[0] = 1;
  for (std::size_t k = 1; k < p; ++k) raise(knots, span, t, k, basis.value);
  if (p > 0) {
    differentiate(knots, span, p, basis.value, basis.derivative);
    raise(knots, span, t, p, basis.value);
  }
  return basis;
}

CurvePoint evaluate(const NurbsCurve& curve, double t) {
  const BasisFunctions basis = basis_functions(curve.knots, curve.degree, t);
  Vec3 sum, sum_derivative;
  double weight = 0, weight_derivative = 0;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(curve.degree); ++i) {
    const std::size_t pole = basis.first + i;
    const double w = curve.weights.empty() ? 1.0 : curve.weights[pole];
    sum += curve.poles[pole] * (basis.value[i] * w);
    sum_derivative += curve.poles[pole] * (basis.derivative[i] * w);
    weight += basis.value[i] * w;
    weight_derivative += basis.derivative[i] * w;
  }
  const Vec3 point = sum / weight;  // (2.22)
  return {point, (sum_derivative - point * weight_derivative) / weight};
}

Vec3 point_at(const NurbsCurve& curve, double t) { return evaluate(curve, t).point; }

NurbsCurve nurbs_circle(const Vec3& center, const Vec3& x, const Vec3& y, double radius) {
  constexpr std::array<double, 9> along = {1, 1, 0, -1, -1, -1, 0, 1, 1},
                                  across = {0, 1, 1, 1, 0, -1, -1, -1, 0};
  NurbsCurve circle;
  circle.degree = 2;
  circle.knots = {0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1};
  for (std::size_t i = 0; i < along.size(); ++i) {
    circle.poles.push_back(center + (x * along[i] + y * across[i]) * radius);
    circle.weights.push_back(i % 2 == 0 ? 1.0 : std::sqrt(0.5));
  }
  return circle;
}

void validate_knots(std::span<const double> knots, int degree, std::size_t poles,
                    const char* what) {
  const std::string name = what;
  if (degree < 1 || degree > highest_degree)
    throw Error(name + ": degree " + std::to_string(degree) + " is not in 1 to 25");
  const auto p = static_cast<std::size_t>(degree);
  if (poles < p + 1 || knots.size() != poles + p + 1)
    throw Error(name + ": the numbers of knots, poles and the degree do not fit");
  for (std::size_t i = 0; i < knots.size(); ++i)
    if (!std::isfinite(knots[i]) || (i > 0 && knots[i] < knots[i - 1]))
      throw Error(name + ": knots descend or are not finite");
  if (!(knots[p] < knots[poles])) throw Error(name + ": the range of its parameter is empty");
  for (std::size_t i = 1; i + p < knots.size() - 1; ++i)
    if (!(knots[i] < knots[i + p]) && knots[i] > knots[p] && knots[i] < knots[poles])
      throw Error(name + ": a knot is repeated so often that it falls apart there");
}

void validate(const NurbsCurve& curve) {
  validate_knots(curve.knots, curve.degree, curve.poles.size(), "curve");
  if (!curve.weights.empty() && curve.weights.size() != curve.poles.size())
    throw Error("curve: not one weight a pole");
  for (const double w : curve.weights)
    if (!(w > 0 && std::isfinite(w))) throw Error("curve: a weight is not positive");
  for (const Vec3& pole : curve.poles)
    if (!is_finite(pole)) throw Error("curve: a pole is not finite");
}

}  // namespace spigolo
