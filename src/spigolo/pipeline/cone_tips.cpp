// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/pipeline/cone_tips.cpp
#include "spigolo/pipeline/cone_tips.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "spigolo/mesh/point_cells.h"
#include "spigolo/sheets/normal_equations.h"

namespace spigolo {
namespace {

constexpr double same_tip = 1.0;          // [spacings] tips nearer to each other are one
constexpr double reach = 5.0;             // [spacings] points that far from it tell of a cone
constexpr double farthest_move = 1.5;     // [spacings] of the apex; more is another cone
constexpr std::size_t least_points = 16;  // against six unknowns
constexpr std::size_t unknowns = 6;       // apex, two turns of the axis, half opening
constexpr int most_steps = 20;            // doubts first wide, then narrow
constexpr double damping = 1e-6;          // against unknowns that the points leave open
constexpr double wide = 0.5;              // [spacings] residuals that count half
constexpr double narrow = 0.05;           // ... in the end, plus twice the noise: no cone beyond
constexpr double least_share = 0.8;       // of the points within `narrow`

constexpr double most_noise = 0.15;     // [spacings] more hides which cone it is
constexpr double off_curve = 2.0;       // [spacings] from all creases
constexpr std::size_t most_stray = 64;  // places looked at; more are no few tips
constexpr double plain_share = 0.9;     // of the points on a cone without a label ...
constexpr double top = 2.5;             // [spacings] ... and of those that near to its apex
const double thinnest = radians(8), flattest = radians(65);  // half the opening
constexpr std::size_t sectors = 6;                           // around the axis, none empty

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

double share_on(const Cone& cone, const std::vector<Vec3>& points, double within, double doubt) {
  std::size_t all = 0, on_it = 0;
  for (const Vec3& p : points) {
    if (distance(p, cone.apex) > within) continue;
    ++all;
    on_it += std::abs(residual(cone, place_of(cone, p))) < doubt;
  }
  return all == 0 ? 0 : static_cast<double>(on_it) / static_cast<double>(all);
}

// Points and noise in spacings, from a place near the apex.
std::optional<Cone> fit_cone(const std::vector<Vec3>& points, double noise) {
  if (points.size() < least_points) return std::nullopt;
  const double most = narrow + 2 * noise;
  Cone cone = first_cone(points, {});
  for (int step = 0; step < most_steps; ++step)
    if (!improve(points, 2 * step < most_steps ? wide : most, cone)) return std::nullopt;
  if (!(norm(cone.apex) <= farthest_move) || share_on(cone, points, infinity, most) < least_share)
    return std::nullopt;
  return cone;
}

// The points lie all around the axis, on the cone up to its apex, and it is neither a needle nor
// nearly flat: a tip even if no label says so.
bool is_plain(const Cone& cone, const std::vector<Vec3>& points, double noise) {
  if (!(cone.half > thinnest && cone.half < flattest)) return false;
  const double most = narrow + 2 * noise;
  if (share_on(cone, points, infinity, most) < plain_share ||
      share_on(cone, points, top, most) < plain_share)
    return false;
  const Vec3 x = any_perpendicular(cone.axis), y = cross(cone.axis, x);
  std::array<bool, sectors> seen{};
  for (const Vec3& p : points) {
    const Vec3 d = p - cone.apex;
    const double turn = (std::atan2(dot(d, y), dot(d, x)) + pi) / (2 * pi);
    seen[std::min(sectors - 1, static_cast<std::size_t>(turn * sectors))] = true;
  }
  return std::all_of(seen.begin(), seen.end(), [](bool s) { return s; });
}

// Per place, what the points near it are from it [spacings].
std::vector<std::vector<Vec3>> around(std::span<const Vec3> points, std::span<const Vec3> places,
                                      double spacing) {
  std::vector<std::vector<Vec3>> found(places.size());
  PointCells cells(reach * spacing, places.size());
  for (const Vec3& place : places) cells.insert(place);
  for (const Vec3& p : points)
    cells.any_within(p, reach * spacing, [&](std::uint32_t i, double) {
      if (distance(p, places[i]) < reach * spacing) found[i].push_back((p - places[i]) / spacing);
      return false;
    });
  return found;
}

bool any_near(const std::vector<Vec3>& places, const Vec3& p, double r) {
  return std::any_of(places.begin(), places.end(),
                     [&](const Vec3& place) { return distance(place, p) < r; });
}

// Points called sharp that lie on no curve, some spacings apart: what is a tip may be among them.
std::vector<Vec3> find_stray(std::span<const Vec3> points, const Features& features,
                             const FeatureCurves& network, double spacing) {
  PointCells creases(off_curve * spacing, points.size() / 16);
  for (const FeatureCurve& curve : network.curves)
    for (const Vec3& p : curve.points) creases.insert(p);
  const auto found = [](std::uint32_t, double) { return true; };
  std::vector<Vec3> stray;
  for (std::size_t i = 0; i < features.size() && stray.size() < most_stray; ++i) {
    const PointKind kind = features.kind[i];
    if ((kind == PointKind::edge || kind == PointKind::corner) &&
        !any_near(stray, points[i], same_tip * spacing) &&
        !creases.any_within(points[i], off_curve * spacing, found))
      stray.push_back(points[i]);
  }
  return stray;
}

}  // namespace

std::vector<Vec3> find_cone_tips(std::span<const Vec3> points, const Features& features,
                                 const FeatureCurves& network, double spacing, double noise) {
  std::vector<Vec3> named, tips;
  for (std::size_t i = 0; i < features.size(); ++i) {
    const Vec3& p = features.crease_point[i];
    if (features.kind[i] == PointKind::tip && is_finite(p) &&
        !any_near(named, p, same_tip * spacing))
      named.push_back(p);
  }
  const auto near_named = around(points, named, spacing);
  for (std::size_t i = 0; i < named.size(); ++i)
    if (const auto cone = fit_cone(near_named[i], noise))
      tips.push_back(named[i] + spacing * cone->apex);
  if (noise > most_noise) return tips;
  const std::vector<Vec3> stray = find_stray(points, features, network, spacing);
  const auto near_stray = around(points, stray, spacing);
  for (std::size_t i = 0; i < stray.size(); ++i) {
    const auto cone = fit_cone(near_stray[i], noise);
    if (!cone || !is_plain(*cone, near_stray[i], noise)) continue;
    const Vec3 apex = stray[i] + spacing * cone->apex;
    if (!any_near(tips, apex, reach * spacing)) tips.push_back(apex);
  }
  return tips;
}

}  // namespace spigolo
