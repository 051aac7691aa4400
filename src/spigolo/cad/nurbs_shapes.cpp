// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/cad/nurbs_shapes.cpp
#include "spigolo/cad/nurbs_shapes.h"

#include <cmath>

#include "spigolo/cad/spline_rows.h"

namespace spigolo {
namespace {

// u and v exchanged for what is swept: the profile's poles times the rings' places.
NurbsSurface empty_sweep(const NurbsCurve& profile) {
  NurbsSurface s;
  s.degree_u = profile.degree;
  s.knots_u = profile.knots;
  s.poles_u = profile.poles.size();
  s.period_u = 1;
  return s;
}

NurbsCurve ring(const TubeFrame& frame, double radius) {
  const Vec3 x = any_perpendicular(frame.axis), y = cross(frame.axis, x);
  return nurbs_circle(frame.origin, x, y, radius);
}

}  // namespace

NurbsSurface nurbs_cone(const TubeFrame& frame, double radius, double end_radius, double length) {
  const NurbsCurve begin = ring(frame, radius);
  const NurbsCurve end = ring({frame.origin + frame.axis * length, frame.axis}, end_radius);
  NurbsSurface s = empty_sweep(begin);
  s.degree_v = 1;
  s.knots_v = {0, 0, 1, 1};
  s.poles_v = 2;
  for (std::size_t i = 0; i < s.poles_u; ++i)
    for (const NurbsCurve* curve : {&begin, &end}) {
      s.poles.push_back(curve->poles[i]);
      s.weights.push_back(curve->weights[i]);
    }
  return s;
}

NurbsSurface nurbs_tube(const TubeFrame& frame, double radius, double length) {
  return nurbs_cone(frame, radius, radius, length);
}

NurbsSurface nurbs_u_tube(const TubeFrame& frame, const Vec3& side, double radius, double leg,
                          double gap) {
  const NurbsCurve circle = nurbs_circle(frame.origin, side, cross(frame.axis, side), radius);
  NurbsSurface s = empty_sweep(circle);
  s.degree_v = 2;
  s.knots_v = {0, 0, 0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1, 1, 1};
  s.poles_v = 9;
  const double half = std::sqrt(0.5);
  for (std::size_t i = 0; i < s.poles_u; ++i) {
    const Vec3 foot = circle.poles[i];
    const Vec3 top = foot + frame.axis * leg;
    // Lever from the axis of the bend, which lies at gap / 2.
    const double lever = gap / 2 - dot(foot - frame.origin, side);
    const Vec3 across = side * lever, up = frame.axis * lever;
    const Vec3 far = top + across * 2;
    const std::array<Vec3, 9> row = {foot,
                                     foot + frame.axis * (leg / 2),
                                     top,
                                     top + up,
                                     top + across + up,
                                     far + up,
                                     far,
                                     far - frame.axis * (leg / 2),
                                     far - frame.axis * leg};
    const std::array<double, 9> weight = {1, 1, 1, half, 1, half, 1, 1, 1};
    for (std::size_t j = 0; j < row.size(); ++j) {
      s.poles.push_back(row[j]);
      s.weights.push_back(weight[j] * circle.weights[i]);
    }
  }
  return s;
}

NurbsSurface nurbs_extrusion(std::span<const Vec3> profile, const Vec3& way) {
  const NurbsCurve curve = spline_through(profile, true);
  NurbsSurface s = empty_sweep(curve);
  s.degree_v = 1;
  s.knots_v = {0, 0, 1, 1};
  s.poles_v = 2;
  for (const Vec3& pole : curve.poles) {
    s.poles.push_back(pole);
    s.poles.push_back(pole + way);
  }
  return s;
}

NurbsSurface nurbs_sheet(double width, double depth, std::size_t n,
                         const std::function<Vec3(double x, double y)>& place) {
  NurbsSurface s;
  s.poles_u = s.poles_v = n;
  s.knots_u.assign(4, 0);
  for (std::size_t i = 1; i + 3 < n; ++i)
    s.knots_u.push_back(static_cast<double>(i) / static_cast<double>(n - 3));
  s.knots_u.insert(s.knots_u.end(), 4, 1);
  s.knots_v = s.knots_u;
  // Greville abscissae: where height is linear in x and y, so is the surface.
  const auto greville = [&](std::size_t i) {
    return (s.knots_u[i + 1] + s.knots_u[i + 2] + s.knots_u[i + 3]) / 3;
  };
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      s.poles.push_back(place(width * greville(i), depth * greville(j)));
  return s;
}

}  // namespace spigolo
