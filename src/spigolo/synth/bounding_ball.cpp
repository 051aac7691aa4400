// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/bounding_ball.cpp - the smallest ball around a few points
#include <optional>

#include "spigolo/synth/polyhedron.h"

namespace spigolo {
namespace {

constexpr double tolerance = 1e-12;  // share of the radius that counts as outside

struct Ball {
  Vec3 center;
  double radius = 0;
};

/// The smallest ball with all support points on its sphere: its center lies in their hull's plane
/// and solves 2 (s_i - s_0) . c = |s_i - s_0|^2 there. Empty for dependent points.
std::optional<Ball> ball_through(const std::vector<Vec3>& s) {
  if (s.size() == 1) return Ball{s[0], 0};
  const Vec3 a = s[1] - s[0];
  Vec3 c;
  if (s.size() == 2) {
    c = a * 0.5;
  } else {
    const Vec3 b = s[2] - s[0];
    const Vec3 d = s.size() == 3 ? cross(a, b) : s[3] - s[0];
    const double volume = dot(cross(a, b), d);
    if (std::abs(volume) <= tolerance * norm(a) * norm(b) * norm(d)) return std::nullopt;
    const double last = s.size() == 3 ? 0 : squared_norm(d);
    c = (squared_norm(a) * cross(b, d) + squared_norm(b) * cross(d, a) + last * cross(a, b)) /
        (2 * volume);
  }
  return Ball{s[0] + c, norm(c)};
}

/// Welzl's recursion: the ball of the first n points that has the support on its sphere.
std::optional<Ball> smallest_ball(const std::vector<Vec3>& points, std::size_t n,
                                  std::vector<Vec3>& support) {
  std::optional<Ball> ball;
  if (!support.empty()) ball = ball_through(support);
  if (support.size() == 4) return ball;
  for (std::size_t i = 0; i < n; ++i) {
    if (ball && distance(ball->center, points[i]) <= ball->radius * (1 + tolerance)) continue;
    support.push_back(points[i]);
    if (const auto larger = smallest_ball(points, i, support)) ball = larger;
    support.pop_back();
  }
  return ball;
}

}  // namespace

double bounding_radius(const std::vector<Vec3>& points) {
  std::vector<Vec3> support;
  const auto ball = smallest_ball(points, points.size(), support);
  return ball ? ball->radius : 0;
}

}  // namespace spigolo
