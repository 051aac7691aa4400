// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/passing.cpp
#include "spigolo/sheets/passing.h"

#include <cmath>

namespace spigolo {
namespace {

constexpr double tiny = 1e-300;  // farther off the sheets than a double can tell

double normal_share_below(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

}  // namespace

double passing_probability(const SheetVerdict& edge, const Vec3& sample, double spacing,
                           double near, double noise) {
  const Vec3 d = (sample - edge.crease_point) / spacing;
  double within = 0, all = 0;
  for (const Vec3& into : edge.into) {
    const double t = dot(d, into) / noise, off = dot(d, cross(into, edge.direction)) / noise;
    const double weight = std::exp(-0.5 * off * off), before = normal_share_below(-t);
    within += weight * (normal_share_below(near / noise - t) - before);
    all += weight * (1 - before);
  }
  if (all < tiny) return norm(d) < near ? 1 : 0;
  return within / all;
}

}  // namespace spigolo
