// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/sheet.cpp
#include "spigolo/sheets/sheet.h"

#include <cmath>

#include "spigolo/core/symmetric3.h"

namespace spigolo {
namespace {

constexpr int plane_points = 3;
constexpr int quadric_freedom = 6, plane_freedom = 3;
// Curvature that the points do not determine (all on a line or two) is drawn to zero.
constexpr double curvature_weight = 1e-7;

struct Local {
  double u, v, w;
};

Local local(const Sheet& s, const Vec3& p) {
  const Vec3 d = (p - s.origin) / s.spacing;
  return {dot(d, s.u), dot(d, s.v), dot(d, s.n)};
}

struct Gradient {
  double u, v;
};

Gradient gradient(const Sheet& s, const Local& q) {
  return {s.a[1] + 2 * s.a[3] * q.u + s.a[4] * q.v, s.a[2] + s.a[4] * q.u + 2 * s.a[5] * q.v};
}

double offset(const Sheet& s, const Local& q) {
  return q.w -
         (s.a[0] + q.u * (s.a[1] + s.a[3] * q.u + s.a[4] * q.v) + q.v * (s.a[2] + s.a[5] * q.v));
}

// Cholesky factorization and two substitutions; false where the matrix is not positive.
bool solve(std::array<std::array<double, 6>, 6>& m, std::array<double, 6>& x) {
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = m[i][j];
      for (std::size_t k = 0; k < j; ++k) sum -= m[i][k] * m[j][k];
      if (i == j && !(sum > 0)) return false;
      m[i][j] = i == j ? std::sqrt(sum) : sum / m[j][j];
    }
  }
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t k = 0; k < i; ++k) x[i] -= m[i][k] * x[k];
    x[i] /= m[i][i];
  }
  for (std::size_t i = 6; i-- > 0;) {
    for (std::size_t k = i + 1; k < 6; ++k) x[i] -= m[k][i] * x[k];
    x[i] /= m[i][i];
  }
  return true;
}

template <class Function>
void for_each_used(std::span<const Vec3> points, std::span<const char> use, Function&& function) {
  for (std::size_t i = 0; i < points.size(); ++i)
    if (use.empty() || use[i]) function(points[i]);
}

// Frame with n across the direction of least spread, a0 the mean height.
void fit_plane(std::span<const Vec3> points, std::span<const char> use, Sheet& s) {
  Vec3 mean;
  for_each_used(points, use, [&](const Vec3& p) { mean += p - s.origin, ++s.support; });
  if (s.support < plane_points) return;
  mean = mean / s.support;
  Symmetric3 scatter;
  for_each_used(points, use,
                [&](const Vec3& p) { scatter.add((p - s.origin - mean) / s.spacing); });
  s.n = smallest_axis(scatter).axis;
  s.u = any_perpendicular(s.n);
  s.v = cross(s.n, s.u);
  s.a[0] = dot(mean, s.n) / s.spacing;
}

bool fit_quadric(std::span<const Vec3> points, std::span<const char> use, Sheet& s) {
  std::array<std::array<double, 6>, 6> m{};
  std::array<double, 6> x{};
  for_each_used(points, use, [&](const Vec3& p) {
    const auto [u, v, w] = local(s, p);
    const std::array<double, 6> row = {1, u, v, u * u, u * v, v * v};
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j <= i; ++j) m[i][j] += row[i] * row[j];
      x[i] += row[i] * w;
    }
  });
  double trace = 0;
  for (std::size_t i = 0; i < 6; ++i) trace += m[i][i];
  for (std::size_t i = 3; i < 6; ++i) m[i][i] += curvature_weight * trace;
  if (!solve(m, x)) return false;
  s.a = x;
  return true;
}

}  // namespace

double height(const Sheet& sheet, const Vec3& p) {
  const Local q = local(sheet, p);
  const Gradient g = gradient(sheet, q);
  return offset(sheet, q) / std::sqrt(1 + g.u * g.u + g.v * g.v);
}

Vec3 normal_at(const Sheet& sheet, const Vec3& p) {
  const Gradient g = gradient(sheet, local(sheet, p));
  return normalized(sheet.n - sheet.u * g.u - sheet.v * g.v);
}

Sheet fit_sheet(std::span<const Vec3> points, std::span<const char> use, double spacing,
                SheetModel model) {
  Sheet sheet;
  sheet.origin = points[0];
  sheet.spacing = spacing;
  fit_plane(points, use, sheet);
  if (sheet.support < plane_points) return {};
  const bool curved = model == SheetModel::quadric && sheet.support >= quadric_points &&
                      fit_quadric(points, use, sheet);
  double squares = 0;
  for_each_used(points, use, [&](const Vec3& p) {
    const double h = height(sheet, p);
    squares += h * h;
  });
  const int freedom = sheet.support - (curved ? quadric_freedom : plane_freedom);
  sheet.deviation = freedom > 0 ? std::sqrt(squares / freedom) : infinity;
  return sheet;
}

}  // namespace spigolo
