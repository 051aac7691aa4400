// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/gauss_map/gauss_map.cpp - spread of the normals around their principal direction
#include "spigolo/gauss_map/gauss_map.h"

#include <algorithm>
#include <cmath>

namespace spigolo {
namespace {

// Row of m - value * identity.
struct Rows {
  Vec3 r0, r1, r2;
};

Rows shifted_rows(const Symmetric3& m, double value) {
  return {{m.xx - value, m.xy, m.xz}, {m.xy, m.yy - value, m.yz}, {m.xz, m.yz, m.zz - value}};
}

// Largest root of the characteristic polynomial, by its trigonometric solution.
double largest_eigenvalue(const Symmetric3& m) {
  const double mean = (m.xx + m.yy + m.zz) / 3;
  const double a = m.xx - mean, b = m.yy - mean, c = m.zz - mean;
  const double off = m.xy * m.xy + m.xz * m.xz + m.yz * m.yz;
  const double p = std::sqrt((a * a + b * b + c * c + 2 * off) / 6);
  if (p == 0) return mean;
  const double determinant =
      a * (b * c - m.yz * m.yz) - m.xy * (m.xy * c - m.yz * m.xz) + m.xz * (m.xy * m.yz - b * m.xz);
  const double cosine = std::clamp(determinant / (2 * p * p * p), -1.0, 1.0);
  return mean + 2 * p * std::cos(std::acos(cosine) / 3);
}

}  // namespace

PrincipalAxis principal_axis(const Symmetric3& m) {
  const double value = largest_eigenvalue(m);
  const auto [r0, r1, r2] = shifted_rows(m, value);
  // The eigenvector is perpendicular to all rows; the longest cross product is the safest.
  Vec3 best = cross(r0, r1);
  for (const Vec3& candidate : {cross(r0, r2), cross(r1, r2)})
    if (squared_norm(candidate) > squared_norm(best)) best = candidate;
  if (squared_norm(best) > 0) return {normalized(best), value};
  // A double eigenvalue: any direction perpendicular to the one row that is left, if there is one.
  const Vec3 row = std::max(
      {r0, r1, r2}, [](const Vec3& u, const Vec3& v) { return squared_norm(u) < squared_norm(v); });
  return {squared_norm(row) > 0 ? any_perpendicular(normalized(row)) : Vec3{0, 0, 1}, value};
}

NormalSpread normal_spread(const GaussMap& map) {
  if (map.size == 0) return {{0, 0, 1}, 0};
  Symmetric3 m;
  for (std::size_t t = 0; t < map.size; ++t) {
    const double x = map.x[t], y = map.y[t], z = map.z[t];
    m.xx += x * x, m.xy += x * y, m.xz += x * z;
    m.yy += y * y, m.yz += y * z, m.zz += z * z;
  }
  const PrincipalAxis principal = principal_axis(m);
  // The eigenvalue sums the squared cosines, what is missing are the squared sines.
  const double squared_sine = 1 - principal.value / (m.xx + m.yy + m.zz);
  return {principal.axis, std::asin(std::sqrt(std::clamp(squared_sine, 0.0, 1.0)))};
}

}  // namespace spigolo
