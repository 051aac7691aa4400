// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/curve.cpp - exact curves
#include "spigolo/synth/curve.h"

#include <utility>

#include "spigolo/synth/minimize.h"

namespace spigolo {

Frame frame_along(const Vec3& origin, const Vec3& axis) {
  const Vec3 z = normalized(axis);
  const Vec3 x = any_perpendicular(z);
  return {origin, x, cross(z, x), z};
}

Curve segment(const Vec3& a, const Vec3& b) {
  const Vec3 d = b - a;
  return {
      .at = [a, b, d](double t) { return t < 0.5 ? a + t * d : b - (1 - t) * d; },
      .nearest =
          [a, d](const Vec3& p) { return std::clamp(dot(p - a, d) / squared_norm(d), 0.0, 1.0); },
      .closed = false};
}

Curve circle(const Frame& frame, double radius) {
  return {.at =
              [frame, radius](double t) {
                return frame.world(radius * std::cos(2 * pi * t), radius * std::sin(2 * pi * t), 0);
              },
          .nearest =
              [frame](const Vec3& p) {
                const Vec3 q = frame.local(p);
                const double t = std::atan2(q.y, q.x) / (2 * pi);
                return t < 0 ? t + 1 : t;
              },
          .closed = true};
}

Curve parametric(std::function<Vec3(double t)> at, bool closed, int seeds) {
  auto nearest = [at, closed, seeds](const Vec3& p) {
    return minimize_unit([&](double t) { return squared_distance(p, at(t)); }, seeds, closed);
  };
  return {std::move(at), nearest, closed};
}

}  // namespace spigolo
