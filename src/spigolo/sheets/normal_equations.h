// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/normal_equations.h - least squares of a quadratic height field, from its moments
#pragma once

#include <array>
#include <cmath>
#include <span>

#include "spigolo/sheets/sheet.h"

namespace spigolo {

/// A place in a sheet's frame, in its spacings.
struct FramePlace {
  double u, v, w;
};

inline FramePlace in_frame(const Sheet& s, const Vec3& p) {
  const Vec3 d = (p - s.origin) / s.spacing;
  return {dot(d, s.u), dot(d, s.v), dot(d, s.n)};
}

using Matrix6 = std::array<std::array<double, 6>, 6>;

// Draws the curvature of a sheet to zero, the same in whatever frame: a3^2 + a4^2 / 2 + a5^2 does
// not change when the frame turns about its normal.
inline void add_ridge(Matrix6& m, double weight) {
  m[3][3] += weight, m[4][4] += weight / 2, m[5][5] += weight;
}

// Cholesky factorization and two substitutions of the first n rows; false where the matrix is not
// positive.
inline bool solve(Matrix6& m, std::array<double, 6>& x, std::size_t n = 6) {
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = m[i][j];
      for (std::size_t k = 0; k < j; ++k) sum -= m[i][k] * m[j][k];
      if (i == j && !(sum > 0)) return false;
      m[i][j] = i == j ? std::sqrt(sum) : sum / m[j][j];
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) x[i] -= m[i][k] * x[k];
    x[i] /= m[i][i];
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) x[i] -= m[k][i] * x[k];
    x[i] /= m[i][i];
  }
  return true;
}

// The moments of a weighted height field up to the fourth order, as the normal equations need them.
struct Moments {
  std::array<double, 15> uv{};  // 1, u, v, uu, uv, vv, uuu, uuv, uvv, vvv, uuuu .. vvvv
  std::array<double, 6> w{};    // height by 1, u, v, uu, uv, vv

  void add(double weight, const FramePlace& q) {
    const double u = q.u, v = q.v, uu = u * u, vv = v * v, cu = weight * u, cv = weight * v;
    const double cuu = cu * u, cuv = cu * v, cvv = cv * v;
    const std::array<double, 15> term = {weight,   cu,          cv,       cuu,         cuv,
                                         cvv,      cuu * u,     cuu * v,  cvv * u,     cvv * v,
                                         cuu * uu, cuu * u * v, cuu * vv, cvv * v * u, cvv * vv};
    for (std::size_t i = 0; i < 15; ++i) uv[i] += term[i];
    for (std::size_t i = 0; i < 6; ++i) w[i] += term[i] * q.w;
  }

  Matrix6 matrix() const {
    constexpr std::array<std::array<std::size_t, 6>, 6> place = {{{0, 1, 2, 3, 4, 5},
                                                                  {1, 3, 4, 6, 7, 8},
                                                                  {2, 4, 5, 7, 8, 9},
                                                                  {3, 6, 7, 10, 11, 12},
                                                                  {4, 7, 8, 11, 12, 13},
                                                                  {5, 8, 9, 12, 13, 14}}};
    Matrix6 m;
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = 0; j < 6; ++j) m[i][j] = uv[place[i][j]];
    return m;
  }
};

/// Weighted least squares in the frame that the sheet has; ridge: share of the weight that draws
/// curvature (of a plane: tilt) to zero. False, and nothing is changed, where it is not determined.
inline bool solve_quadric(std::span<const Vec3> points, std::span<const double> weights,
                          double ridge, Sheet& s) {
  Moments moments;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (weights[i] > 0) moments.add(weights[i], in_frame(s, points[i]));
  Matrix6 m = moments.matrix();
  std::array<double, 6> a = moments.w;
  add_ridge(m, ridge * moments.uv[0]);
  if (!solve(m, a)) return false;
  s.a = a;
  return true;
}

inline bool solve_plane(std::span<const Vec3> points, std::span<const double> weights, double ridge,
                        Sheet& s) {
  double sum = 0, su = 0, sv = 0, sw = 0, uu = 0, uv = 0, vv = 0, uw = 0, vw = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(weights[i] > 0)) continue;
    const FramePlace q = in_frame(s, points[i]);
    const double u = weights[i] * q.u, v = weights[i] * q.v, w = weights[i] * q.w;
    sum += weights[i], su += u, sv += v, sw += w;
    uu += u * q.u, uv += u * q.v, vv += v * q.v, uw += u * q.w, vw += v * q.w;
  }
  Matrix6 m{};
  m[0] = {sum, su, sv, 0, 0, 0};
  m[1] = {su, uu + ridge * sum, uv, 0, 0, 0};
  m[2] = {sv, uv, vv + ridge * sum, 0, 0, 0};
  std::array<double, 6> a = {sw, uw, vw, 0, 0, 0};
  if (!solve(m, a, 3)) return false;
  s.a = a;
  return true;
}

}  // namespace spigolo
