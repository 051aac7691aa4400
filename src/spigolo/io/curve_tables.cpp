// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/curve_tables.cpp
#include "spigolo/io/curve_tables.h"

#include <algorithm>
#include <cmath>

#include "spigolo/io/text.h"

namespace spigolo {
namespace {

// Polyline through the points, by its length.
RationalSpline polyline_of(const FeatureCurve& curve) {
  RationalSpline spline;
  spline.poles = curve.points;
  if (curve.closed) spline.poles.push_back(curve.points.front());
  if (curve.shape == CurveShape::line) spline.poles = {curve.points.front(), curve.points.back()};
  spline.knots.push_back(0);
  spline.knots.push_back(0);
  for (std::size_t i = 1; i < spline.poles.size(); ++i)
    spline.knots.push_back(spline.knots.back() + distance(spline.poles[i], spline.poles[i - 1]));
  spline.knots.push_back(spline.knots.back());
  return spline;
}

// Quadratic pieces of at most a right angle each.
RationalSpline round_spline(const FeatureCurve& curve) {
  RationalSpline spline;
  spline.degree = 2;
  const double sweep = sweep_of(curve);
  const auto pieces = static_cast<std::size_t>(std::max(1.0, std::ceil(sweep / half_pi - 1e-9)));
  const double half = sweep / static_cast<double>(pieces) / 2;
  const Vec3 x = normalized(curve.points.front() - curve.center), y = cross(curve.axis, x);
  const auto at = [&](double angle, double radius) {
    return curve.center + (x * std::cos(angle) + y * std::sin(angle)) * radius;
  };
  spline.knots.assign(3, 0.0);
  spline.poles = {curve.points.front()};
  spline.weights = {1};
  for (std::size_t p = 0; p < pieces; ++p) {
    const double middle = half * static_cast<double>(2 * p + 1);
    spline.poles.push_back(at(middle, curve.radius / std::cos(half)));
    spline.poles.push_back(at(middle + half, curve.radius));
    spline.weights.insert(spline.weights.end(), {std::cos(half), 1});
    const double knot = static_cast<double>(p + 1) * 2 * half;
    spline.knots.insert(spline.knots.end(), p + 1 == pieces ? 3 : 2, knot);
  }
  spline.poles.back() = curve.closed ? curve.points.front() : curve.points.back();
  return spline;
}

}  // namespace

CurveVertices shared_vertices(const FeatureCurves& network) {
  CurveVertices table;
  for (const FeatureCorner& corner : network.corners) table.points.push_back(corner.position);
  table.angle.assign(table.points.size(), 0.0);
  for (const FeatureCurve& curve : network.curves) {
    auto& row = table.curve.emplace_back();
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      const bool first = i == 0, last = i + 1 == curve.points.size() && !curve.closed;
      const std::int32_t corner = first ? curve.corner[0] : last ? curve.corner[1] : no_corner;
      if (corner != no_corner) {
        row.push_back(static_cast<std::uint32_t>(corner));
        table.angle[row.back()] = std::max(table.angle[row.back()], curve.angle[i]);
        continue;
      }
      row.push_back(static_cast<std::uint32_t>(table.points.size()));
      table.points.push_back(curve.points[i]);
      table.angle.push_back(curve.angle[i]);
    }
    if (curve.closed) row.push_back(row.front());
  }
  return table;
}

AngleRange angle_range(const FeatureCurve& curve) {
  AngleRange range;
  if (curve.angle.empty()) return range;
  range.min = *std::min_element(curve.angle.begin(), curve.angle.end());
  range.max = *std::max_element(curve.angle.begin(), curve.angle.end());
  for (const double a : curve.angle) range.mean += a;
  range.mean /= static_cast<double>(curve.angle.size());
  return range;
}

const char* kind_name(CurveKind kind) { return kind == CurveKind::border ? "border" : "edge"; }

RationalSpline rational_spline(const FeatureCurve& curve) {
  const bool round = curve.shape == CurveShape::circle || curve.shape == CurveShape::arc;
  const bool free = curve.shape == CurveShape::spline && !curve.spline.poles.empty();
  RationalSpline spline = round ? round_spline(curve) : RationalSpline{};
  if (free) spline = {curve.spline.degree, curve.spline.knots, curve.spline.poles, {}};
  if (!round && !free) spline = polyline_of(curve);
  spline.weights.resize(spline.poles.size(), 1.0);
  return spline;
}

double sweep_of(const FeatureCurve& curve) {
  if (curve.closed) return 2 * pi;
  const Vec3 a = curve.points.front() - curve.center, b = curve.points.back() - curve.center;
  const double height = dot(a, curve.axis) * dot(b, curve.axis);
  const double angle = std::atan2(dot(cross(a, b), curve.axis), dot(a, b) - height);
  return angle > 0 ? angle : angle + 2 * pi;
}

void append_double(std::string& out, double value) {
  append_number(out, value, ScalarType::float64);
}

}  // namespace spigolo
