// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/placed_crease.cpp
#include "spigolo/sheets/placed_crease.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "spigolo/sheets/heights.h"

namespace spigolo {
namespace {

constexpr double exact_fit = 0.005;  // [spacings] rms of a sheet that may be trusted so far
constexpr int least_support = 6;     // points it was fitted to
constexpr double through = 0.02;     // [spacings] of the point from both sheets
constexpr double on_it = 0.03;       // [spacings] of other points, farther from where it was fitted
constexpr std::size_t most_sheets = 8;
constexpr double aside = 0.3;        // [spacings] from the crease: on one sheet only
constexpr double beside = 2.5;       // [spacings] along it: a sheet may end elsewhere
constexpr double least_depth = 0.3;  // [spacings] of a sheet's points from its nearest row on
constexpr std::size_t least_on_both = 2, least_on_side = 3;

// An exact sheet through the point and what lies on it.
struct Exact {
  const Sheet* sheet = nullptr;
  Vec3 normal;  // at the point
  PointSet on;
};

struct ExactSheets {
  std::array<Exact, most_sheets> of;
  std::size_t count = 0;
};

// Of sheets with nearly the same tangent plane, the one that holds most points.
ExactSheets exact_sheets(std::span<const Sheet> sheets, std::span<const Vec3> around,
                         std::span<const std::uint32_t> members, double least_deviation) {
  ExactSheets found;
  std::array<double, max_cover_points> off;
  const double alike = std::cos(least_deviation);
  for (const std::uint32_t m : members) {
    const Sheet& sheet = sheets[m];
    if (sheet.support < least_support || sheet.deviation > exact_fit ||
        std::abs(height(sheet, around[0])) > through)
      continue;
    Exact next{&sheet, normal_at(sheet, around[0]), {}};
    heights(sheet, around, off.data());
    for (std::size_t t = 0; t < around.size(); ++t) next.on[t] = std::abs(off[t]) < on_it;
    const auto end = found.of.begin() + static_cast<std::ptrdiff_t>(found.count);
    const auto same = std::find_if(found.of.begin(), end, [&](const Exact& e) {
      return std::abs(dot(e.normal, next.normal)) > alike;
    });
    if (same == end && found.count < most_sheets) found.of[found.count++] = next;
    if (same != end && next.on.count() > same->on.count()) *same = next;
  }
  return found;
}

// The points of a sheet alone on either side of the crease.
struct Sides {
  Vec3 in;  // unit, square to the crease in the sheet, to where more points are
  std::size_t front = 0, behind = 0;
  double nearest = infinity, farthest = 0;  // [spacings] from the crease
};

Sides sides_of(const Exact& sheet, const PointSet& alone, std::span<const Vec3> around,
               const Vec3& along) {
  Sides sides{cross(sheet.normal, along)};
  for (std::size_t t = 1; t < around.size(); ++t) {
    if (!alone[t]) continue;
    const Vec3 d = (around[t] - around[0]) / sheet.sheet->spacing;
    const double across = dot(d, sides.in);
    if (std::abs(dot(d, along)) > beside) continue;
    if (std::abs(across) <= aside) continue;
    ++(across > 0 ? sides.front : sides.behind);
    sides.nearest = std::min(sides.nearest, std::abs(across));
    sides.farthest = std::max(sides.farthest, std::abs(across));
  }
  if (sides.behind > sides.front) {
    std::swap(sides.front, sides.behind);
    sides.in = -sides.in;
  }
  return sides;
}

// Two rows of points make a plane of any facet of a rounding.
bool is_broad(const Sides& sides) {
  return sides.front >= least_on_side && sides.farthest > sides.nearest + least_depth;
}

bool ends(const Sides& sides) { return sides.behind == 0; }

}  // namespace

std::optional<SheetVerdict> find_placed_crease(std::span<const Vec3> points,
                                               std::span<const Sheet> sheets,
                                               std::span<const std::uint32_t> members,
                                               double least_deviation) {
  std::array<Vec3, max_cover_points> place;
  for (std::size_t m = 0; m < members.size(); ++m) place[m] = points[members[m]];
  const std::span<const Vec3> around(place.data(), members.size());
  const ExactSheets exact = exact_sheets(sheets, around, members, least_deviation);
  std::optional<SheetVerdict> best;
  std::size_t most = 0;
  for (std::size_t a = 0; a < exact.count; ++a)
    for (std::size_t b = a + 1; b < exact.count; ++b) {
      const Exact &one = exact.of[a], &other = exact.of[b];
      const PointSet both = one.on & other.on;
      if (both.count() < 1 + least_on_both || both.count() <= most) continue;
      const Vec3 along = normalized(cross(one.normal, other.normal));
      const Sides in_one = sides_of(one, one.on & ~both, around, along),
                  in_other = sides_of(other, other.on & ~both, around, along);
      if (!is_broad(in_one) || !is_broad(in_other) || !(ends(in_one) || ends(in_other))) continue;
      const double deviation = pi - angle_between(in_one.in, in_other.in);
      if (deviation < least_deviation) continue;
      most = both.count();
      best = {PointKind::edge, deviation, 1, around[0], along, {in_one.in, in_other.in}, 2};
    }
  return best;
}

}  // namespace spigolo
