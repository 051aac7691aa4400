// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mls/quadratic.cpp
#include "spigolo/mls/quadratic.h"

#include <algorithm>
#include <cmath>

namespace spigolo {
namespace {

using Six = std::array<double, 6>;

constexpr std::size_t first_order = 3;  // coefficients before the second-order ones
constexpr double ridge = 1e-10, plane_ridge = 1e-14;

// Cholesky factorization and two substitutions, in place.
bool solve(std::array<Six, 6>& m, Six& x) {
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

}  // namespace

TangentFrame tangent_frame(const Vec3& origin, const Vec3& n, double unit) {
  const Vec3 u = any_perpendicular(n);
  return {origin, u, cross(n, u), n, unit};
}

Quadratic fit_quadratic(const TangentFrame& frame, std::span<const Vec3> points,
                        std::span<const double> weight) {
  std::array<Six, 6> m{};
  Quadratic g;
  double sum = 0;
  for (std::size_t p = 0; p < points.size(); ++p) {
    const Vec3 d = (points[p] - frame.origin) / frame.unit;
    const double u = dot(d, frame.u), v = dot(d, frame.v), height = dot(d, frame.n);
    const Six row = {1, u, v, u * u, u * v, v * v};
    for (std::size_t i = 0; i < 6; ++i) {
      const double w = weight[p] * row[i];
      for (std::size_t j = 0; j <= i; ++j) m[i][j] += w * row[j];
      g.a[i] += w * height;
    }
    sum += weight[p];
  }
  const double mean = g.a[0] / sum;
  for (std::size_t i = 1; i < 6; ++i) m[i][i] += sum * (i < first_order ? plane_ridge : ridge);
  if (!solve(m, g.a)) return {{mean, 0, 0, 0, 0, 0}};
  return g;
}

Vec3 normal_of(const Quadratic& g, const TangentFrame& frame) {
  return normalized(frame.n - frame.u * g.a[1] - frame.v * g.a[2]);
}

std::array<double, 2> curvatures_of(const Quadratic& g, const TangentFrame& frame) {
  const double gu = g.a[1], gv = g.a[2];
  const double e = 1 + gu * gu, f = gu * gv, gg = 1 + gv * gv;  // first fundamental form
  const double length = std::sqrt(1 + gu * gu + gv * gv);
  const double l = 2 * g.a[3] / length, m = g.a[4] / length, n = 2 * g.a[5] / length;  // second
  const double area = e * gg - f * f;
  const double mean = (e * n - 2 * f * m + gg * l) / (2 * area);
  const double gauss = (l * n - m * m) / area;
  const double half = std::sqrt(std::max(0.0, mean * mean - gauss));
  return {(mean + half) / frame.unit, (mean - half) / frame.unit};
}

}  // namespace spigolo
