// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/core/symmetric3.cpp - eigenvalues by the trigonometric solution of the cubic
#include "spigolo/core/symmetric3.h"

#include <algorithm>
#include <cmath>

namespace spigolo {
namespace {

// Root of the characteristic polynomial: the largest, or the smallest one.
double extreme_eigenvalue(const Symmetric3& m, bool largest) {
  const double mean = (m.xx + m.yy + m.zz) / 3;
  const double a = m.xx - mean, b = m.yy - mean, c = m.zz - mean;
  const double off = m.xy * m.xy + m.xz * m.xz + m.yz * m.yz;
  const double p = std::sqrt((a * a + b * b + c * c + 2 * off) / 6);
  if (p == 0) return mean;
  const double determinant =
      a * (b * c - m.yz * m.yz) - m.xy * (m.xy * c - m.yz * m.xz) + m.xz * (m.xy * m.yz - b * m.xz);
  const double third = std::acos(std::clamp(determinant / (2 * p * p * p), -1.0, 1.0)) / 3;
  return mean + 2 * p * std::cos(largest ? third : third + 2 * pi / 3);
}

PrincipalAxis axis_of(const Symmetric3& m, double value) {
  // The eigenvector is perpendicular to all rows; the longest cross product is the safest.
  const Vec3 r0{m.xx - value, m.xy, m.xz}, r1{m.xy, m.yy - value, m.yz},
      r2{m.xz, m.yz, m.zz - value};
  Vec3 best = cross(r0, r1);
  for (const Vec3& candidate : {cross(r0, r2), cross(r1, r2)})
    if (squared_norm(candidate) > squared_norm(best)) best = candidate;
  const Vec3 row = std::max(
      {r0, r1, r2}, [](const Vec3& u, const Vec3& v) { return squared_norm(u) < squared_norm(v); });
  // Parallel rows, but for rounding, are a double eigenvalue: any direction perpendicular to them.
  constexpr double parallel = 1e-7;
  if (norm(best) > parallel * squared_norm(row)) return {normalized(best), value};
  return {squared_norm(row) > 0 ? any_perpendicular(normalized(row)) : Vec3{0, 0, 1}, value};
}

}  // namespace

PrincipalAxis largest_axis(const Symmetric3& m) { return axis_of(m, extreme_eigenvalue(m, true)); }

PrincipalAxis smallest_axis(const Symmetric3& m) {
  return axis_of(m, extreme_eigenvalue(m, false));
}

}  // namespace spigolo
