// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/pipeline/cone_tips.cpp
#include "spigolo/pipeline/cone_tips.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "spigolo/sheets/normal_equations.h"

namespace spigolo {
namespace {

constexpr double same_tip = 1.0;          // [spacings] tips nearer to each other are one
constexpr double reach = 5.0;             // [spacings] points that far from it tell of a cone
constexpr double farthest_move = 1.0;     // [spacings] of the apex; more is another cone
constexpr std::size_t least_points = 16;  // against six unknowns
constexpr std::size_t unknowns = 6;       // apex, two turns of the axis, half opening
constexpr int most_steps = 20;            // doubts first wide, then narrow
constexpr double damping = 1e-6;          // against unknowns that the points leave open
constexpr double wide = 0.5;              // [spacings] residuals that count half
constexpr double narrow = 0.05;           // ... in the end, plus twice the noise: no cone beyond
constexpr double least_share = 0.8;       // of the points within `narrow`

struct Cone {
  Vec3 apex, axis;  // unit, into the cone
  double half = 0;  // [rad] of the opening
};

struct Place {
  double along, away;  // from the apex, from the axis
  Vec3 outward;        // unit, off the axis
};

Place place_of(const Cone& cone, const Vec3& p) {
  const Vec3 d = p - cone.apex;
  const double along = dot(d, cone.axis);
  const Vec3 off = d - along * cone.axis;
  return {along, norm(off), normalized(off)};
}

double residual(const Cone& cone, const Place& at) {
  return std::cos(cone.half) * at.away - std::sin(cone.half) * at.along;
}

Cone first_cone(const std::vector<Vec3>& points, const Vec3& apex) {
  Cone cone{apex, {}, 0};
  for (const Vec3& p : points) cone.axis += normalized(p - apex);
  cone.axis = normalized(cone.axis);
  for (const Vec3& p : points)
    cone.half += angle_between(cone.axis, p - apex) / static_cast<double>(points.size());
  return cone;
}

// One step of Gauss and Newton; residuals beyond `doubt` count little.
bool improve(const std::vector<Vec3>& points, double doubt, Cone& cone) {
  const Vec3 x = any_perpendicular(cone.axis), y = cross(cone.axis, x);
  const double c = std::cos(cone.half), s = std::sin(cone.half);
  Matrix6 m{};
  std::array<double, unknowns> change{};
  for (const Vec3& p : points) {
    const Place at = place_of(cone, p);
    const double f = residual(cone, at), share = f / doubt, root = 1 / (1 + share * share),
                 weight = root * root, turn = -(at.along * c + at.away * s);
    const Vec3 pull = s * cone.axis - c * at.outward;
    const std::array<double, unknowns> slope = {pull.x,
                                                pull.y,
                                                pull.z,
                                                turn * dot(at.outward, x),
                                                turn * dot(at.outward, y),
                                                -(s * at.away + c * at.along)};
    for (std::size_t i = 0; i < unknowns; ++i) {
      change[i] -= weight * f * slope[i];
      for (std::size_t j = 0; j < unknowns; ++j) m[i][j] += weight * slope[i] * slope[j];
    }
  }
  for (std::size_t i = 0; i < unknowns; ++i)
    m[i][i] += damping * static_cast<double>(points.size());
  if (!solve(m, change)) return false;
  cone.apex += Vec3{change[0], change[1], change[2]};
  cone.axis = normalized(cone.axis + change[3] * x + change[4] * y);
  cone.half += change[5];
  return true;
}

// Points and noise in spacings, from the apex that labels name; the better one.
Vec3 apex_of_cone(const std::vector<Vec3>& points, double noise) {
  if (points.size() < least_points) return {};
  const double most = narrow + 2 * noise;
  Cone cone = first_cone(points, {});
  for (int step = 0; step < most_steps; ++step)
    if (!improve(points, 2 * step < most_steps ? wide : most, cone)) return {};
  const auto on_it = std::count_if(points.begin(), points.end(), [&](const Vec3& p) {
    return std::abs(residual(cone, place_of(cone, p))) < most;
  });
  const bool good = norm(cone.apex) <= farthest_move &&
                    static_cast<double>(on_it) >= least_share * static_cast<double>(points.size());
  return good ? cone.apex : Vec3{};
}

}  // namespace

std::vector<Vec3> find_cone_tips(std::span<const Vec3> points, const Features& features,
                                 double spacing, double noise) {
  std::vector<Vec3> tips;
  for (std::size_t i = 0; i < features.size(); ++i) {
    const Vec3& p = features.crease_point[i];
    if (features.kind[i] != PointKind::tip || !is_finite(p)) continue;
    if (std::none_of(tips.begin(), tips.end(),
                     [&](const Vec3& tip) { return distance(tip, p) < same_tip * spacing; }))
      tips.push_back(p);
  }
  for (Vec3& tip : tips) {
    std::vector<Vec3> around;
    for (const Vec3& p : points)
      if (distance(p, tip) < reach * spacing) around.push_back((p - tip) / spacing);
    tip += spacing * apex_of_cone(around, noise);
  }
  return tips;
}

}  // namespace spigolo
