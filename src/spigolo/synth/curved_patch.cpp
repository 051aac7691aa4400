// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/curved_patch.cpp - curved pieces: turned, ruled and trimmed ones
#include <array>

#include "spigolo/synth/minimize.h"
#include "spigolo/synth/patch.h"

namespace spigolo {
namespace {

double azimuth(const Vec3& local) {
  const double a = std::atan2(local.y, local.x);
  return a < 0 ? a + 2 * pi : a;
}

/// The end of the sector nearer to an azimuth outside of it.
double clamp_azimuth(double a, double sector) {
  if (a <= sector) return a;
  return a - sector < 2 * pi - a ? sector : 0;
}

/// The point of the turned meridian at distance rho from the axis and height z, above p's azimuth.
Vec3 turn(const Frame& frame, const Vec3& local, const Vec2& m) {
  const double rho = std::hypot(local.x, local.y);
  if (rho == 0) return frame.world(m.x, 0, m.y);
  return frame.world(local.x / rho * m.x, local.y / rho * m.x, m.y);
}

Vec3 turn(const Frame& frame, double angle, const Vec2& m) {
  return frame.world(std::cos(angle) * m.x, std::sin(angle) * m.x, m.y);
}

/// Integral over the unit square: 5-point Gauss rule on cells of a 16 x 16 grid.
double integrate(const std::function<double(double, double)>& f) {
  constexpr std::array<double, 5> node = {0.046910077030668, 0.23076534494715845, 0.5,
                                          0.76923465505284155, 0.953089922969332};
  constexpr std::array<double, 5> weight = {0.11846344252809454, 0.23931433524968324,
                                            0.28444444444444444, 0.23931433524968324,
                                            0.11846344252809454};
  constexpr int cells = 16;
  double sum = 0;
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j)
      for (std::size_t a = 0; a < 5; ++a)
        for (std::size_t b = 0; b < 5; ++b)
          sum += weight[a] * weight[b] * f((i + node[a]) / cells, (j + node[b]) / cells);
  return sum / (cells * cells);
}

}  // namespace

Patch cylinder_patch(const Frame& frame, double radius, double height, double sector) {
  auto sample = [=](Random& random) {
    const double a = random.uniform(0, sector);
    return turn(frame, a, {radius, random.uniform(0, height)});
  };
  auto nearest = [=](const Vec3& p) {
    const Vec3 q = frame.local(p);
    const double z = std::clamp(q.z, 0.0, height), a = azimuth(q);
    if (a <= sector) return turn(frame, q, {radius, z});
    return turn(frame, clamp_azimuth(a, sector), {radius, z});
  };
  return {radius * sector * height, sample, nearest};
}

Patch turned_segment(const Frame& frame, const Vec2& a, const Vec2& b) {
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  auto sample = [=](Random& random) {
    double t = random.uniform();  // density proportional to the distance from the axis
    while (random.uniform(0, std::max(a.x, b.x)) >= a.x + t * (b.x - a.x)) t = random.uniform();
    const Vec2 m{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
    return turn(frame, random.uniform(0, 2 * pi), m);
  };
  auto nearest = [=](const Vec3& p) {
    const Vec3 q = frame.local(p);
    const double x = std::hypot(q.x, q.y) - a.x, y = q.z - a.y;
    const double along = (x * (b.x - a.x) + y * (b.y - a.y)) / (length * length);
    const double t = std::clamp(along, 0.0, 1.0);
    return turn(frame, q, {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
  };
  return {pi * (a.x + b.x) * length, sample, nearest};
}

Patch turned_arc(const Frame& frame, const MeridianArc& arc) {
  const double sweep = arc.to - arc.from, r = arc.radius, c = arc.center.x;
  auto at = [=](double angle) {
    return Vec2{std::max(0.0, c + r * std::cos(angle)), arc.center.y + r * std::sin(angle)};
  };
  auto sample = [=](Random& random) {
    double angle = random.uniform(arc.from, arc.to);
    while (random.uniform(0, c + r) >= at(angle).x) angle = random.uniform(arc.from, arc.to);
    return turn(frame, random.uniform(0, 2 * pi), at(angle));
  };
  auto nearest = [=](const Vec3& p) {
    const Vec3 q = frame.local(p);
    double angle = std::atan2(q.z - arc.center.y, std::hypot(q.x, q.y) - c) - arc.from;
    angle -= 2 * pi * std::floor(angle / (2 * pi));
    return turn(frame, q, at(arc.from + clamp_azimuth(angle, sweep)));
  };
  return {2 * pi * r * (c * sweep + r * (std::sin(arc.to) - std::sin(arc.from))), sample, nearest};
}

Patch octant_patch(const Frame& frame, double radius) {
  auto sample = [=](Random& random) {
    const Vec3 d = random.on_sphere() * radius;
    return frame.world(std::abs(d.x), std::abs(d.y), std::abs(d.z));
  };
  auto nearest = [=](const Vec3& p) {
    const Vec3 q = frame.local(p);
    Vec3 d{std::max(q.x, 0.0), std::max(q.y, 0.0), std::max(q.z, 0.0)};
    if (squared_norm(d) == 0)
      d = q.x >= q.y && q.x >= q.z ? Vec3{1, 0, 0} : q.y >= q.z ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
    d = normalized(d) * radius;
    return frame.world(d.x, d.y, d.z);
  };
  return {half_pi * radius * radius, sample, nearest};
}

Patch trimmed_patch(const Patch& whole, const Trim& trim) {
  auto sample = [=](Random& random) {
    Vec3 p = whole.sample(random);
    while (!trim.keeps(p)) p = whole.sample(random);
    return p;
  };
  auto nearest = [=](const Vec3& p) {
    const Vec3 foot = whole.nearest(p);
    if (trim.keeps(foot)) return foot;
    Vec3 best{infinity, infinity, infinity};
    for (const Curve& curve : trim.border)
      if (const Vec3 q = nearest_point(curve, p); distance(p, q) < distance(p, best)) best = q;
    return best;
  };
  return {trim.area, sample, nearest};
}

Patch ruled_patch(const Ruled& ruled) {
  auto sample = [ruled](Random& random) {
    double u = 0, v = 0;
    do {
      u = random.uniform(), v = random.uniform();
    } while (random.uniform(0, ruled.largest) >= ruled.element(u, v));
    return ruled.a(u) + v * (ruled.b(u) - ruled.a(u));
  };
  auto nearest = [ruled](const Vec3& p) {
    auto foot = [&](double u) {
      const Vec3 a = ruled.a(u), d = ruled.b(u) - a;
      return a + std::clamp(dot(p - a, d) / squared_norm(d), 0.0, 1.0) * d;
    };
    auto cost = [&](double u) { return squared_distance(p, foot(u)); };
    return foot(minimize_unit(cost, ruled.seeds, false));
  };
  return {integrate(ruled.element), sample, nearest};
}

}  // namespace spigolo
