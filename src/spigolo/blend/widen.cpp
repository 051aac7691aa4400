// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/widen.cpp
#include "spigolo/blend/widen.h"

#include <algorithm>
#include <cmath>

#include "spigolo/blend/handles.h"

namespace spigolo {
namespace {

const double acute = radians(50);                  // no corner is wider than that
constexpr double half_chord = 0.5;                 // of the radius: where a bend is measured
constexpr double step = 0.125, most_widening = 2;  // of the roundness

double least_angle(const BorderLoop& loop) {
  double least = pi;
  for (const Strand& s : loop.strands) least = std::min(least, s.angle);
  return least;
}

// Curvature of the curve of centers at b, by the parabola through three points.
Vec3 curvature(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double h = distance(a, b), k = distance(b, c);
  return ((c - b) / k - (b - a) / h) * (2 / (h + k));
}

// How sharply the collar bends along the loop, at most: 1 if it does so with the radius
// `roundness`. Behind the ball the bend is narrower by the ball's radius.
double sharpest_turn(const BorderLoop& loop, double roundness) {
  const CenterCurve curve(loop);
  double sharpest = 0;
  for (std::size_t i = 0; i < loop.strands.size(); ++i) {
    const Strand& s = loop.strands[i];
    if (s.angle > acute) continue;
    const auto [a, b] = curve.around(i, half_chord * s.radius);
    if (a == i || b == i) continue;
    const Vec3 bend = curvature(curve.at(a), curve.at(i), curve.at(b));
    const Vec3 outward = -normalized(normalized(s.alpha_handle) + normalized(s.beta_handle));
    sharpest = std::max(sharpest, -dot(bend, outward) * (s.radius + roundness));
  }
  return sharpest;
}

}  // namespace

double widened(double radius, double widening, double angle, double least) {
  if (widening <= 0 || least > acute) return radius;
  return radius + widening * (1 - std::cos(angle) / std::cos(least));
}

bool Widening::improve(const BorderLoop& loop) {
  if (settled_ || least_angle(loop) > acute) return false;
  const double turn = sharpest_turn(loop, roundness_);
  if (turn < least_turn_) least_turn_ = turn, best_ = value_;
  settled_ = turn <= 1 || turn > least_turn_ || value_ >= most_widening * roundness_;
  const double last = value_;
  value_ = settled_ ? best_ : value_ + step * roundness_;
  return value_ != last;
}

}  // namespace spigolo
