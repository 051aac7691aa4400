// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/collar.cpp
#include "spigolo/blend/collar.h"

#include <algorithm>
#include <cmath>

namespace spigolo {
namespace {

// Longer handles than those of the arc bring the bend away from the borders, where the MLS kernel
// smooths the jump of curvature.
constexpr double handle_gain = 1.1;
constexpr double longest_handle = 0.9;  // share of the way to X
constexpr double flat = 1e-6;           // [rad] from straight

// Handle of the cubic that follows a circular arc, as a share of the distance from the arc's end to
// where its end tangents cross. angle: between the two sides.
double handle_share(double angle) {
  const double turn = pi - angle;
  if (turn < flat) return std::min(handle_gain * 2 / 3, longest_handle);
  return std::min(handle_gain * 4 / 3 * std::tan(turn / 4) / std::tan(turn / 2), longest_handle);
}

// From a border towards X, in the tangent plane.
Vec3 handle(const Vec3& end, const Vec3& normal, const Vec3& x, const Vec3& fallback) {
  const Vec3 way = x - end;
  const Vec3 flat_way = way - normal * dot(way, normal);
  const Vec3 direction = norm(flat_way) > flat * norm(way) ? normalized(flat_way) : fallback;
  return direction * norm(way);
}

}  // namespace

StripPoles tangent_strip(const Strand& s) {
  const double share = handle_share(s.angle);
  return {s.alpha, s.alpha + handle(s.alpha, s.alpha_normal, s.x, -s.toward_face) * share,
          s.beta + handle(s.beta, s.beta_normal, s.x, -s.toward_cloud) * share, s.beta};
}

Collar build_collar(const BorderLoop& loop) {
  std::vector<StripPoles> strips;
  for (const Strand& s : loop.strands) strips.push_back(tangent_strip(s));
  Collar collar;
  collar.surface = surface_through(strips, loop.closed, &collar.station);
  double agreement = 0;
  for (std::size_t i = 0; i < strips.size(); ++i) {
    const NurbsPoint p = evaluate(collar.surface, collar.station[i], 0);
    const Vec3 out = loop.strands[i].alpha_normal * loop.side;
    agreement += dot(normalized(cross(p.du, p.dv)), out);
  }
  collar.outward = agreement > 0;
  return collar;
}

Vec3 collar_normal(const Collar& collar, double u, double v) {
  const Vec3 n = normal_at(collar.surface, u, v);
  return collar.outward ? n : -n;
}

}  // namespace spigolo
