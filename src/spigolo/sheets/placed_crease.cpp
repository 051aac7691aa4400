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
#include "spigolo/sheets/sector.h"

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
// An end: the sheet has nothing in such a sector, and all that lies there is steeply off it.
constexpr double end_gap = radians(150), bend_margin = 0.64, bend_slope = 0.36;  // sine, tangent
constexpr double off_reach = 2;  // [spacings] so close the surface goes on
constexpr double crest = 1.3;    // [spacings] the width of a crest that has no samples of its own
constexpr std::size_t least_off = 2;
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

// What lies around the supposed end of a sheet at the point.
struct End {
  Vec3 out, along;                          // unit, in the sheet: away from it, along its end
  std::size_t row = 0, before = 0;          // points of the sheet on its end, before it
  double nearest = infinity, farthest = 0;  // [spacings] of those before it
  std::size_t off = 0;                      // points close by that are clearly off the sheet
  double closest = infinity;                // [spacings] the nearest of them that is not below it,
  Vec3 next;                                // and the way there, square to the end
  bool is_none = false;                     // the sheet goes on, or the surface only bends

  bool holds() const {
    return !is_none && row >= least_on_both && before >= least_on_side &&
           farthest > nearest + least_depth && off >= least_off && closest <= crest;
  }
};

void add_own(End& end, const Vec3& d) {
  const double beyond = dot(d, end.out), aside_of = std::abs(dot(d, end.along));
  if (aside_of > beside) return;
  end.is_none |= beyond > aside;
  if (std::abs(beyond) <= aside) {
    end.row += aside_of > aside;
    return;
  }
  ++end.before;
  end.nearest = std::min(end.nearest, -beyond);
  end.farthest = std::max(end.farthest, -beyond);
}

// meets: it is of another sheet that meets this one close by, and is no news.
void add_other(End& end, const Exact& sheet, const Vec3& d, double height, bool meets) {
  const double away = norm(d), beyond = dot(d, end.out);
  if (away > off_reach) return;
  const double lateral = std::hypot(beyond, dot(d, end.along));
  end.is_none |=
      lateral > aside && beyond > -bend_margin * lateral && height < bend_slope * lateral;
  if (height <= aside || meets) return;
  ++end.off;
  if (beyond < -aside || away >= end.closest) return;
  end.closest = away;
  end.next = normalized(end.out * beyond + sheet.normal * dot(d, sheet.normal));
}

// The sheet ends in a row of samples, and what goes on from there is too narrow for a sheet: the
// crest of a rib as thick as one spacing.
std::optional<SheetVerdict> find_placed_end(const Exact& sheet, std::span<const Vec3> points,
                                            std::span<const Sheet> sheets,
                                            std::span<const std::uint32_t> members,
                                            double least_deviation) {
  const Sector gap = widest_sector(points, members, *sheet.sheet, sheet.on);
  if (gap.width < end_gap) return std::nullopt;
  const double middle = gap.from + gap.width / 2;
  const Vec3 out = sheet.sheet->u * std::cos(middle) + sheet.sheet->v * std::sin(middle);
  End end;
  end.out = normalized(out - sheet.normal * dot(out, sheet.normal));
  end.along = cross(sheet.normal, end.out);
  const Vec3& p = points[members[0]];
  for (std::size_t t = 1; t < members.size(); ++t) {
    const Vec3& q = points[members[t]];
    const Vec3 d = (q - p) / sheet.sheet->spacing;
    if (sheet.on[t])
      add_own(end, d);
    else
      add_other(end, sheet, d, std::abs(height(*sheet.sheet, q)),
                find_crease(*sheet.sheet, sheets[members[t]], p).has_value());
  }
  if (!end.holds()) return std::nullopt;
  const double deviation = pi - angle_between(-end.out, end.next);
  if (deviation < least_deviation) return std::nullopt;
  return SheetVerdict{PointKind::edge, deviation, 1, p, end.along, {-end.out, end.next}, 2};
}

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
  for (std::size_t a = 0; !best && a < exact.count; ++a)
    best = find_placed_end(exact.of[a], points, sheets, members, least_deviation);
  return best;
}

}  // namespace spigolo
