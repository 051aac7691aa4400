// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/shape_curve.cpp
#include "spigolo/trace/shape_curve.h"

#include <algorithm>
#include <cmath>

#include "spigolo/trace/spline.h"

namespace spigolo {
namespace {

constexpr double point_step = 1;         // [spacings] between the points of a curve, at most
constexpr double point_sagitta = 0.004;  // [spacings] between a round curve and its polyline
constexpr double spline_step = 0.5;      // [spacings] between the points of a spline
constexpr double end_length = 6;         // [spacings] of a curve that tells how it ends
constexpr std::size_t least_members = 4;

std::optional<Vec3> corner_at(const CurveDraft& draft, int side, std::span<const Vec3> junctions) {
  const int j = draft.junction[static_cast<std::size_t>(side)];
  if (j == no_junction) return std::nullopt;
  return junctions[static_cast<std::size_t>(j)];
}

const Station& end_station(const CurveDraft& draft, int side) {
  return side == 0 ? draft.stations.front() : draft.stations.back();
}

std::vector<Vec3> points_between(const Vec3& a, const Vec3& b) {
  const double count = std::max(1.0, std::ceil(distance(a, b) / point_step));
  std::vector<Vec3> points;
  for (double k = 0; k < count; ++k) points.push_back(a + (b - a) * (k / count));
  points.push_back(b);
  return points;
}

void finish_line(const CurveDraft& draft, const LineFit& line, std::span<const Vec3> junctions,
                 FeatureCurve& curve) {
  std::array<Vec3, 2> end;
  for (int side = 0; side < 2; ++side) {
    const Vec3 free = end_station(draft, side).place;
    end[static_cast<std::size_t>(side)] =
        corner_at(draft, side, junctions)
            .value_or(line.place + line.direction * dot(free - line.place, line.direction));
  }
  curve.shape = CurveShape::line;
  curve.points = points_between(end[0], end[1]);
}

// Points counterclockwise about the axis, from `from` through `sweep` radians.
void round_points(const CircleFit& circle, const Vec3& from, double sweep, FeatureCurve& curve) {
  const double step =
      std::min(point_step, std::sqrt(8 * circle.radius * point_sagitta)) / circle.radius;
  const double count = std::max(curve.closed ? 12.0 : 2.0, std::ceil(sweep / step));
  const Vec3 x = normalized(from - circle.center), y = cross(circle.axis, x);
  for (double k = 0; k < count + (curve.closed ? 0 : 1); ++k) {
    const double a = sweep * k / count;
    curve.points.push_back(circle.center + (x * std::cos(a) + y * std::sin(a)) * circle.radius);
  }
  curve.center = circle.center;
  curve.axis = circle.axis;
  curve.radius = circle.radius;
}

// [rad] from a to b counterclockwise about the axis, in [0, 2 pi).
double sweep_between(const CircleFit& circle, const Vec3& a, const Vec3& b) {
  const Vec3 p = a - circle.center, q = b - circle.center;
  const double angle = std::atan2(dot(cross(p, q), circle.axis),
                                  dot(p, q) - dot(p, circle.axis) * dot(q, circle.axis));
  return angle < 0 ? angle + 2 * pi : angle;
}

void finish_circle(const CurveDraft& draft, CircleFit circle, FeatureCurve& curve) {
  const auto& s = draft.stations;
  const Vec3 a = s[0].place - circle.center, b = s[s.size() / 4].place - circle.center;
  if (dot(cross(a, b), circle.axis) < 0) circle.axis = -circle.axis;
  curve.shape = CurveShape::circle;
  round_points(circle, circle.nearest(s[0].place), 2 * pi, curve);
}

// The recognised circle, moved to pass its corners; false if they leave no arc of it.
bool finish_arc(const CurveDraft& draft, const CircleFit& fitted, std::span<const Vec3> junctions,
                FeatureCurve& curve) {
  const Vec3 middle = fitted.nearest(draft.stations[draft.stations.size() / 2].place);
  std::array<Vec3, 2> end;
  for (int side = 0; side < 2; ++side)
    end[static_cast<std::size_t>(side)] =
        corner_at(draft, side, junctions).value_or(fitted.nearest(end_station(draft, side).place));
  auto circle = circle_through(end[0], middle, end[1]);
  if (!circle) return false;
  const double sweep = sweep_between(*circle, end[0], end[1]);
  if (sweep_between(*circle, end[0], middle) > sweep) return false;
  curve.shape = CurveShape::arc;
  round_points(*circle, end[0], sweep, curve);
  curve.points.front() = end[0];
  curve.points.back() = end[1];
  return true;
}

void finish_spline(const CurveDraft& draft, std::span<const Vec3> junctions,
                   const ShapeTolerances& tolerances, FeatureCurve& curve) {
  std::vector<Vec3> through;
  for (const Station& s : draft.stations) through.push_back(s.place);
  for (int side = 0; side < 2; ++side)
    if (const auto corner = corner_at(draft, side, junctions))
      (side == 0 ? through.front() : through.back()) = *corner;
  curve.shape = CurveShape::spline;
  curve.spline = fit_spline(through, curve.closed, tolerances.spline);
  const double count =
      std::max(curve.closed ? 12.0 : 2.0, std::ceil(draft.guide.length() / spline_step));
  const double end = last_parameter(curve.spline);
  for (double k = 0; k < count + (curve.closed ? 0 : 1); ++k)
    curve.points.push_back(value(curve.spline, end * k / count));
  if (!curve.closed) {
    curve.points.front() = through.front();
    curve.points.back() = through.back();
  }
}

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 d = b - a;
  const double square = squared_norm(d);
  const double t = square > 0 ? std::clamp(dot(p - a, d) / square, 0.0, 1.0) : 0;
  return distance(p, a + d * t);
}

// rms distance of the members to the finished polyline, whose points run evenly along it.
double residual_of(const CurveDraft& draft, std::span<const CreaseSample> samples,
                   const FeatureCurve& curve) {
  const std::size_t n = curve.points.size(), segments = curve.closed ? n : n - 1;
  double sum = 0;
  for (const Member& m : draft.members) {
    const double share = m.arc / draft.guide.length() * static_cast<double>(segments);
    const auto middle = static_cast<std::ptrdiff_t>(share);
    double least = infinity;
    for (std::ptrdiff_t i = middle - 4; i <= middle + 4; ++i) {
      if (i < 0 || i >= static_cast<std::ptrdiff_t>(segments)) continue;
      const auto k = static_cast<std::size_t>(i);
      least = std::min(least, distance_to_segment(samples[m.sample].place, curve.points[k],
                                                  curve.points[(k + 1) % n]));
    }
    sum += least * least;
  }
  return draft.members.empty() ? 0 : std::sqrt(sum / static_cast<double>(draft.members.size()));
}

// Share of the length that has a member within one and a half spacings along the curve.
double share_covered(const CurveDraft& draft) {
  constexpr double near = 1.5;
  double covered = 0, upto = 0;
  for (const Member& m : draft.members) {
    const double from = std::max(upto, m.arc - near);
    const double to = std::min(draft.guide.length(), m.arc + near);
    if (to > from) covered += to - from;
    upto = std::max(upto, to);
  }
  return std::min(1.0, covered / draft.guide.length());
}

std::int8_t convexity(const CurveDraft& draft, std::span<const CreaseSample> samples) {
  int votes = 0, said = 0;
  for (const Member& m : draft.members) {
    votes += samples[m.sample].convex;
    said += samples[m.sample].convex != 0;
  }
  if (said == 0 || 2 * std::abs(votes) < said) return 0;
  return votes > 0 ? std::int8_t{1} : std::int8_t{-1};
}

void angles_along(const CurveDraft& draft, FeatureCurve& curve) {
  const std::size_t n = curve.points.size(), segments = curve.closed ? n : n - 1;
  for (std::size_t i = 0; i < n; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(segments);
    const auto last = static_cast<double>(draft.stations.size() - (curve.closed ? 0 : 1));
    const auto station = static_cast<std::size_t>(share * last + 0.5) % draft.stations.size();
    curve.angle.push_back(draft.stations[station].angle);
  }
}

}  // namespace

LocalCurve end_model(const CurveDraft& draft, int side, std::span<const CreaseSample> samples,
                     const ShapeTolerances& tolerances) {
  const Vec3 end = side == 0 ? draft.guide.places.front() : draft.guide.places.back();
  const double length = draft.guide.length(), reach = std::max(end_length, 2 * tolerances.window);
  Vec3 outward = draft.guide.direction(side == 0 ? 0 : length) * (side == 0 ? -1.0 : 1.0);
  if (const auto* line = std::get_if<LineFit>(&draft.form)) {
    const Vec3 d = line->direction * (dot(line->direction, outward) < 0 ? -1.0 : 1.0);
    return {line->place + d * dot(end - line->place, d), d, {}, line->residual, 1};
  }
  if (const auto* circle = std::get_if<CircleFit>(&draft.form)) {
    const Vec3 place = circle->nearest(end), in = (circle->center - place) / circle->radius;
    Vec3 tangent = cross(circle->axis, in);
    if (dot(tangent, outward) < 0) tangent = -tangent;
    return {place, tangent, in / circle->radius, circle->residual, 1};
  }
  std::vector<Vec3> near;
  for (const Member& m : draft.members)
    if ((side == 0 ? m.arc : length - m.arc) <= reach) near.push_back(samples[m.sample].place);
  if (near.size() < least_members) return {end, outward, {}, 0, 0};
  return fit_local_curve(near, end, outward);
}

FeatureCurve finish(const CurveDraft& draft, std::span<const Vec3> junctions,
                    std::span<const CreaseSample> samples, const ShapeTolerances& tolerances) {
  FeatureCurve curve;
  curve.closed = draft.guide.closed;
  curve.bridged = draft.bridged;
  curve.corner = {draft.junction[0], draft.junction[1]};
  const auto* line = std::get_if<LineFit>(&draft.form);
  const auto* circle = std::get_if<CircleFit>(&draft.form);
  if (line)
    finish_line(draft, *line, junctions, curve);
  else if (circle && curve.closed)
    finish_circle(draft, *circle, curve);
  else if (!circle || !finish_arc(draft, *circle, junctions, curve))
    finish_spline(draft, junctions, tolerances, curve);
  angles_along(draft, curve);
  curve.residual = residual_of(draft, samples, curve);
  curve.confidence = share_covered(draft);
  curve.convex = convexity(draft, samples);
  return curve;
}

}  // namespace spigolo
