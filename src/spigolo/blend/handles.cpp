// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/handles.cpp
#include "spigolo/blend/handles.h"

#include <algorithm>
#include <cmath>

#include "spigolo/blend/smooth_row.h"

namespace spigolo {
namespace {

// Longer handles than those of the arc bring the bend away from the borders, where the MLS kernel
// smooths the jump of curvature.
constexpr double handle_gain = 1.1;
constexpr double longest_handle = 0.9;  // share of the way to X
constexpr double rounding = 1.2;        // standard deviation over h of the MLS weight
constexpr double flat = 1e-6;           // [rad] from straight
constexpr double tangent_reach = 0.25;  // of the radius: where the way of the ball is measured

// Handle of the cubic that follows an arc of radius 1.
double handle_length(double turn) { return handle_gain * 4 / 3 * std::tan(turn / 4); }

// The same as a share of the distance from the arc's end to where its end tangents cross.
double handle_share(double turn) {
  if (turn < flat) return handle_gain * 2 / 3;
  return std::min(handle_length(turn) / std::tan(turn / 2), longest_handle);
}

// From an end of the collar towards a point, in the tangent plane.
Vec3 toward(const Vec3& end, const Vec3& normal, const Vec3& point, const Vec3& fallback) {
  const Vec3 way = point - end;
  const Vec3 flat_way = way - normal * dot(way, normal);
  const Vec3 direction = norm(flat_way) > flat * norm(way) ? normalized(flat_way) : fallback;
  return direction * norm(way);
}

// In the tangent plane, across the ball's way, to the other side's surface. Zero if both sides go
// on straight.
Vec3 across(const Vec3& normal, const Vec3& along, const Vec3& other_normal) {
  const Vec3 direction = normalized(cross(normal, along));
  const double down = dot(direction, other_normal);
  return std::abs(down) < flat ? Vec3{} : down < 0 ? direction : -direction;
}

void point_across(Strand& s, const Vec3& along, int side) {
  const Vec3 face_normal = s.alpha_normal * side;
  const Vec3 from_face = across(face_normal, along, s.beta_normal),
             from_cloud = across(s.beta_normal, along, face_normal);
  if (from_face == Vec3{} || from_cloud == Vec3{}) return point_to_crossing(s);
  const double turn = pi - angle_between(-from_face, -from_cloud);
  s.alpha_handle = from_face * (handle_length(turn) * s.radius);
  s.beta_handle = from_cloud * (handle_length(turn) * s.radius);
}

}  // namespace

CenterCurve::CenterCurve(const BorderLoop& loop) : closed_(loop.closed) {
  for (const Strand& s : loop.strands)
    points_.push_back(s.alpha + s.alpha_normal * (loop.side * s.radius));
}

std::pair<std::size_t, std::size_t> CenterCurve::around(std::size_t i, double reach) const {
  return {beyond(i, reach, false), beyond(i, reach, true)};
}

std::size_t CenterCurve::beyond(std::size_t i, double reach, bool forward) const {
  const std::size_t n = points_.size();
  for (std::size_t step = 1; step < n; ++step) {
    if (!closed_ && (forward ? i + step >= n : step > i)) break;
    const std::size_t j = forward ? (i + step) % n : (i + n - step) % n;
    if (distance(points_[i], points_[j]) >= reach) return j;
  }
  return i;
}

void point_across(BorderLoop& loop) {
  const CenterCurve curve(loop);
  for (std::size_t i = 0; i < loop.strands.size(); ++i) {
    Strand& s = loop.strands[i];
    const auto [a, b] = curve.around(i, tangent_reach * s.radius);
    const Vec3 along = normalized(curve.at(b) - curve.at(a));
    if (along == Vec3{})
      point_to_crossing(s);
    else
      point_across(s, along, loop.side);
  }
}

void round_handles(double smoothing, BorderLoop& loop) {
  std::vector<Vec3> row;
  for (const Strand& s : loop.strands) row.push_back(s.beta + s.beta_handle);
  row = round_corners(row, rounding * smoothing, loop.closed);
  for (std::size_t i = 0; i < row.size(); ++i)
    loop.strands[i].beta_handle = row[i] - loop.strands[i].beta;
}

void point_to_crossing(Strand& s) {
  const double share = handle_share(pi - angle_between(s.alpha - s.x, s.beta - s.x));
  s.alpha_handle = toward(s.alpha, s.alpha_normal, s.x, -s.toward_face) * share;
  s.beta_handle = toward(s.beta, s.beta_normal, s.x, -s.toward_cloud) * share;
}

}  // namespace spigolo
