// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/core/feature_curves.cpp
#include "spigolo/core/feature_curves.h"

#include <algorithm>
#include <string>

#include "spigolo/core/error.h"

namespace spigolo {
namespace {

bool sound(const CurveSpline& s) {
  if (s.poles.empty()) return s.knots.empty();
  const auto degree = static_cast<std::size_t>(s.degree);
  return s.degree >= 1 && s.poles.size() > degree &&
         s.knots.size() == s.poles.size() + degree + 1 &&
         std::is_sorted(s.knots.begin(), s.knots.end()) &&
         std::all_of(s.poles.begin(), s.poles.end(), is_finite);
}

bool sound(const FeatureCurve& curve, const std::vector<FeatureCorner>& corners,
           std::vector<std::int32_t>& ends) {
  if (curve.points.size() < (curve.closed ? 3U : 2U) || curve.angle.size() != curve.points.size())
    return false;
  const bool round = curve.shape == CurveShape::circle || curve.shape == CurveShape::arc;
  if (!sound(curve.spline) || (round && !(curve.radius > 0))) return false;
  if (!std::all_of(curve.points.begin(), curve.points.end(), is_finite)) return false;
  for (std::size_t end = 0; end < 2; ++end) {
    const std::int32_t c = curve.corner[end];
    if (c == no_corner) continue;
    if (c < 0 || static_cast<std::size_t>(c) >= corners.size()) return false;
    const Vec3& last = end == 0 || curve.closed ? curve.points.front() : curve.points.back();
    if (!(corners[static_cast<std::size_t>(c)].position == last)) return false;
    ++ends[static_cast<std::size_t>(c)];
  }
  return true;
}

}  // namespace

double FeatureCurve::length() const {
  double sum = closed && !points.empty() ? distance(points.back(), points.front()) : 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += distance(points[i - 1], points[i]);
  return sum;
}

void validate(const FeatureCurves& network) {
  std::vector<std::int32_t> ends(network.corners.size(), 0);
  for (std::size_t c = 0; c < network.curves.size(); ++c)
    if (!sound(network.curves[c], network.corners, ends))
      throw Error("feature curves: curve " + std::to_string(c) + " is not sound");
  for (std::size_t c = 0; c < ends.size(); ++c)
    if (ends[c] != network.corners[c].valence || !is_finite(network.corners[c].position))
      throw Error("feature curves: corner " + std::to_string(c) + " is not sound");
}

}  // namespace spigolo
