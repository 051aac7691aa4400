// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/cad/nurbs_surface.cpp
#include "spigolo/cad/nurbs_surface.h"

#include <cmath>

#include "spigolo/core/error.h"

namespace spigolo {
namespace {

// Sine of the angle of du and dv below which they count as parallel.
constexpr double parallel = 1e-9;
// Steps towards the middle of the range, as a share of it, that look for a normal.
constexpr std::array<double, 3> nudges = {1e-6, 1e-4, 1e-2};

double wrapped(double t, double period, std::span<const double> knots, int degree) {
  if (period <= 0) return t;
  const double first = first_parameter(knots, degree), last = last_parameter(knots, degree);
  if (t >= first && t <= last) return t;
  return t - period * std::floor((t - first) / period);
}

double nudged(double t, double share, std::span<const double> knots, int degree) {
  const double middle = (first_parameter(knots, degree) + last_parameter(knots, degree)) / 2;
  return t + (middle - t) * share;
}

// Zero where the derivatives span no plane.
Vec3 plain_normal(const NurbsPoint& s) {
  const Vec3 n = cross(s.du, s.dv);
  const double length = norm(n);
  return length > parallel * norm(s.du) * norm(s.dv) ? n / length : Vec3{};
}

// Weighted sums of the poles and of the weights alone.
struct Homogeneous {
  Vec3 sum;
  double weight = 0;

  void add(const Homogeneous& o, double factor) {
    sum += o.sum * factor;
    weight += o.weight * factor;
  }
};

}  // namespace

NurbsPoint evaluate(const NurbsSurface& s, double u, double v) {
  const BasisFunctions bu =
      basis_functions(s.knots_u, s.degree_u, wrapped(u, s.period_u, s.knots_u, s.degree_u));
  const BasisFunctions bv =
      basis_functions(s.knots_v, s.degree_v, wrapped(v, s.period_v, s.knots_v, s.degree_v));
  Homogeneous at, along_u, along_v;
  for (std::size_t i = 0; i <= static_cast<std::size_t>(s.degree_u); ++i) {
    Homogeneous row, row_v;  // sums over v
    for (std::size_t j = 0; j <= static_cast<std::size_t>(s.degree_v); ++j) {
      const std::size_t pole = (bu.first + i) * s.poles_v + bv.first + j;
      const double w = s.weights.empty() ? 1.0 : s.weights[pole];
      const Homogeneous term{s.poles[pole] * w, w};
      row.add(term, bv.value[j]);
      row_v.add(term, bv.derivative[j]);
    }
    at.add(row, bu.value[i]);
    along_u.add(row, bu.derivative[i]);
    along_v.add(row_v, bu.value[i]);
  }
  const Vec3 point = at.sum / at.weight;  // (2.24)
  return {point, (along_u.sum - point * along_u.weight) / at.weight,
          (along_v.sum - point * along_v.weight) / at.weight};
}

Vec3 point_at(const NurbsSurface& s, double u, double v) { return evaluate(s, u, v).point; }

Vec3 normal_at(const NurbsSurface& s, double u, double v) {
  Vec3 n = plain_normal(evaluate(s, u, v));
  for (const double share : nudges) {
    if (n != Vec3{}) break;
    n = plain_normal(evaluate(s, nudged(u, share, s.knots_u, s.degree_u),
                              nudged(v, share, s.knots_v, s.degree_v)));
  }
  return n;
}

void validate(const NurbsSurface& s) {
  validate_knots(s.knots_u, s.degree_u, s.poles_u, "surface, u");
  validate_knots(s.knots_v, s.degree_v, s.poles_v, "surface, v");
  if (s.poles.size() != s.poles_u * s.poles_v) throw Error("surface: poles are missing");
  if (!s.weights.empty() && s.weights.size() != s.poles.size())
    throw Error("surface: not one weight a pole");
  for (const double w : s.weights)
    if (!(w > 0 && std::isfinite(w))) throw Error("surface: a weight is not positive");
  for (const Vec3& pole : s.poles)
    if (!is_finite(pole)) throw Error("surface: a pole is not finite");
}

}  // namespace spigolo
