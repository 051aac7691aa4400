// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/crease.cpp
#include "spigolo/sheets/crease.h"

#include <cmath>

namespace spigolo {
namespace {

constexpr int newton_steps = 6;
constexpr double farthest = 3;            // [spacings] sheets are not trusted beyond
constexpr double parallel_sine2 = 0.01;   // squared sine of the angle between parallel sheets
constexpr double flat_determinant = 0.1;  // of three unit normals that nearly lie in a plane
constexpr double converged = 1e-12;       // [spacings]

}  // namespace

std::optional<Crease> find_crease(const Sheet& a, const Sheet& b, const Vec3& query) {
  const double limit = farthest * a.spacing;
  Crease crease{query, {}, {}};
  for (int step = 0; step < newton_steps; ++step) {
    const Vec3 na = normal_at(a, crease.point), nb = normal_at(b, crease.point);
    const double cosine = dot(na, nb), sine2 = 1 - cosine * cosine;
    if (sine2 < parallel_sine2) return std::nullopt;
    const double ha = height(a, crease.point) * a.spacing, hb = height(b, crease.point) * b.spacing;
    const Vec3 across = (na * (ha - cosine * hb) + nb * (hb - cosine * ha)) / sine2;
    crease.normal = {na, nb};
    crease.direction = normalized(cross(na, nb));
    const Vec3 next = crease.point - across;
    const Vec3 moved = next + crease.direction * dot(query - next, crease.direction);
    const double change = distance(moved, crease.point);
    crease.point = moved;
    if (squared_distance(crease.point, query) > limit * limit) return std::nullopt;
    if (change < converged * a.spacing) break;
  }
  return crease;
}

std::optional<Vec3> find_corner(const std::array<const Sheet*, 3>& sheets, const Vec3& query) {
  const double limit = farthest * sheets[0]->spacing;
  Vec3 x = query;
  for (int step = 0; step < newton_steps; ++step) {
    std::array<Vec3, 3> n;
    std::array<double, 3> h;
    for (std::size_t s = 0; s < 3; ++s) {
      n[s] = normal_at(*sheets[s], x);
      h[s] = height(*sheets[s], x) * sheets[s]->spacing;
    }
    const double determinant = dot(n[0], cross(n[1], n[2]));
    if (std::abs(determinant) < flat_determinant) return std::nullopt;
    x -= (cross(n[1], n[2]) * h[0] + cross(n[2], n[0]) * h[1] + cross(n[0], n[1]) * h[2]) /
         determinant;
    if (squared_distance(x, query) > limit * limit) return std::nullopt;
  }
  return x;
}

}  // namespace spigolo
