// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/verdict.cpp
#include "spigolo/sheets/verdict.h"

#include <algorithm>
#include <cmath>

#include "spigolo/core/parallel.h"
#include "spigolo/sheets/rim.h"
#include "spigolo/sheets/roof.h"
#include "spigolo/sheets/sector.h"

namespace spigolo {
namespace {

constexpr std::size_t grain = 64, clean_grain = 4096;
constexpr double reach = 0.66;       // [spacings] a crease this close passes the point
constexpr double carry_reach = 0.9;  // [spacings] or this close, if no other point is closer
constexpr double carry_beside = 0.8, carry_slack = 0.1;  // [spacings] along and across the edge
constexpr double far_reach = 2;         // [spacings] of the edge that tells why a sheet ends here
constexpr double proposal_reach = 1.3;  // [spacings] with more, one that neighbors may agree with
constexpr double corner_reach = 0.9;    // [spacings] of three sheets' common point
constexpr double common_reach = 0.2;    // [spacings] of a further sheet from their common point
constexpr double sure_reach = 0.45;     // [spacings] so close nobody overshadows
constexpr double shadow_length = 0.6, shadow_depth = 0.35;  // [spacings] along and across the edge
constexpr double exact_length = 0.5;                        // shorter where positions are exact
constexpr double apart = 0.75;  // [spacings] so far from each other each stands for its own place
constexpr double core_reach = 0.4;        // [spacings] nobody at all overshadows
constexpr double lines_core_reach = 0.6;  // [spacings] the same on scan lines, crowded along them
constexpr double placed_reach = 0.02,
                 placed_length = 0.9;        // [spacings] of a sample put on the edge
constexpr double shadow_loss = 1.5;          // of its length, by noise: who is closer is less sure
constexpr double border_gap = radians(150);  // of directions without a neighbor
constexpr std::size_t border_neighbors = 16;
constexpr double bend_of_misfit = 20;       // [rad] more for each spacing of misfit,
constexpr double clear_bend = radians(20);  // but no more than this in all

// Which eighths of a turn hold a neighbor, bit by bit, decides at a glance for most points: with no
// two empty ones side by side no gap is wider than 135 degrees.
constexpr std::array<bool, 256> no_wide_gap = [] {
  std::array<bool, 256> none{};
  for (std::size_t taken = 0; taken < none.size(); ++taken) {
    const std::size_t next = (taken >> 1 | taken << 7) & 255;
    none[taken] = (taken | next) == 255;
  }
  return none;
}();

// Whether neighbors lie on all sides of points[i], by that glance; false may mean either.
bool surrounded(std::span<const Vec3> points, std::size_t i, std::span<const std::uint32_t> row,
                const Sheet& sheet) {
  // Eighths counted from u to v, by: u < 0, v < 0, |v| > |u|.
  constexpr std::array<std::uint8_t, 8> eighth = {0, 3, 7, 4, 1, 2, 6, 5};
  std::size_t taken = 0;
  for (const std::uint32_t m : row) {
    const Vec3 d = points[m] - points[i];
    const double u = dot(d, sheet.u), v = dot(d, sheet.v);
    const bool steep = std::abs(v) > std::abs(u);
    taken |= std::size_t{1} << eighth[static_cast<std::size_t>(u < 0) + 2 * (v < 0) + 4 * steep];
    if (no_wide_gap[taken]) return true;
  }
  return false;
}

double strength_of(double distance, double limit, double deviation) {
  const double near = 1 - 0.5 * distance / limit, clear = std::min(1.0, deviation / radians(40));
  return std::clamp(near * (0.5 + 0.5 * clear), 0.01, 1.0);
}

// [rad] Least bend between two sheets. Without noise, where they fit badly, a slight one may lie
// between their errors: a quadric does not follow a small rounding where samples are sparse.
double least_bend(const Sheet& a, const Sheet& b, double least, bool exact) {
  if (!exact || least > clear_bend) return least;
  return std::min(clear_bend, least + bend_of_misfit * std::max(a.deviation, b.deviation));
}

// The closest of the creases between any two sheets of the cover.
void find_edge(const RoofTest& test, const SheetCover& cover, const Vec3& p,
               const SheetTolerances& tolerances, SheetVerdict& verdict) {
  const double limit = tolerances.exact() ? far_reach : proposal_reach;
  double closest = limit;
  for (std::size_t a = 0; a < cover.count; ++a) {
    for (std::size_t b = a + 1; b < cover.count; ++b) {
      const auto crease = find_crease(*cover.sheet[a], *cover.sheet[b], p);
      if (!crease) continue;
      const double away = distance(crease->point, p) / cover.sheet[a]->spacing;
      if (away > closest) continue;
      const auto roof = test.find(*crease, cover.on[a], cover.on[b]);
      if (!roof || roof->deviation < least_bend(*cover.sheet[a], *cover.sheet[b], test.least(),
                                                tolerances.exact()))
        continue;
      closest = away;
      verdict = {PointKind::edge,
                 roof->deviation,
                 strength_of(away, limit, roof->deviation),
                 crease->point,
                 crease->direction,
                 roof->into,
                 2};
    }
  }
}

// No other point of the neighborhood lies beside the point and is closer to its crease.
bool carries(std::span<const Vec3> points, std::span<const std::uint32_t> members, double spacing,
             const SheetVerdict& verdict) {
  const double away = distance(points[members[0]], verdict.crease_point) / spacing;
  if (away <= reach) return true;
  if (away > carry_reach) return false;
  return std::none_of(members.begin() + 1, members.end(), [&](std::uint32_t m) {
    const Vec3 d = (points[m] - verdict.crease_point) / spacing;
    const double beside = dot(d, verdict.direction);
    return std::abs(beside) < carry_beside &&
           norm(d - verdict.direction * beside) < away - carry_slack;
  });
}

std::uint8_t sheets_through(const Vec3& corner, const SheetCover& cover) {
  std::uint8_t n = 0;
  for (std::size_t s = 0; s < cover.count; ++s)
    n += std::abs(height(*cover.sheet[s], corner)) < common_reach;
  return std::max<std::uint8_t>(n, 3);
}

// Three sheets with a common point close by, if the point is on an edge already.
void find_corner_near(const SheetCover& cover, const Vec3& p, SheetVerdict& verdict) {
  if (verdict.kind != PointKind::edge) return;
  for (std::size_t a = 0; a < cover.count; ++a)
    for (std::size_t b = a + 1; b < cover.count; ++b)
      for (std::size_t c = b + 1; c < cover.count; ++c) {
        const auto corner = find_corner({cover.sheet[a], cover.sheet[b], cover.sheet[c]}, p);
        const double spacing = cover.sheet[a]->spacing;
        if (!corner || distance(*corner, p) > corner_reach * spacing) continue;
        verdict.kind = PointKind::corner;
        verdict.crease_point = *corner;
        verdict.direction = {};
        verdict.sheets = sheets_through(*corner, cover);
        return;
      }
}

bool sharp(const SheetVerdict& v) {
  return v.kind == PointKind::edge || v.kind == PointKind::corner;
}

// Another point of the same crease, beside this one and clearly closer to it. One right on the
// crease, as those of meshes are, casts a longer shadow: if some are placed there, all are.
bool overshadowed(std::span<const Vec3> points, std::span<const std::uint32_t> neighbors,
                  const VerdictRows& verdicts, std::uint32_t i, double spacing,
                  const SheetTolerances& tolerances) {
  const SheetVerdict& mine = verdicts[i];
  const double away = distance(points[i], mine.crease_point) / spacing;
  const bool exact = tolerances.exact();
  const double core = exact && tolerances.on_lines ? lines_core_reach : core_reach;
  if (mine.kind != PointKind::edge || away < core) return false;
  const double length = exact ? exact_length : shadow_length - shadow_loss * tolerances.noise;
  return std::any_of(neighbors.begin(), neighbors.end(), [&](std::uint32_t j) {
    if (!sharp(verdicts[j])) return false;
    const Vec3 d = (points[j] - mine.crease_point) / spacing;
    const double beside = dot(d, mine.direction), across = norm(d - mine.direction * beside);
    if (exact && across < placed_reach) return std::abs(beside) < placed_length;
    return away >= sure_reach && std::abs(beside) < length && across < away - shadow_depth &&
           (!exact || norm(points[j] - points[i]) < apart * spacing);
  });
}

}  // namespace

double least_deviation(double sensitivity) {
  return radians(sensitivity < 0.5 ? 25 - 34 * sensitivity : 10 - 4 * sensitivity);
}

SheetVerdict judge_point(std::span<const Vec3> points, std::span<const Sheet> sheets,
                         std::span<const std::uint32_t> members, const SheetTolerances& tolerances,
                         const SheetOptions& options) {
  SheetVerdict verdict;
  const Vec3& p = points[members[0]];
  const SheetCover cover = cover_neighborhood(points, sheets, members, tolerances);
  if (cover.count == 0) return verdict;
  const double spacing = cover.sheet[0]->spacing, least = least_deviation(options.sensitivity);
  if (cover.count > 1) {
    find_edge(RoofTest(points, members, spacing, least), cover, p, tolerances, verdict);
    if (verdict.kind == PointKind::edge && tolerances.exact() &&
        !carries(points, members, spacing, verdict))
      return {};
    find_corner_near(cover, p, verdict);
  } else if (cover.unexplained == 0) {
    if (members.size() > border_neighbors &&
        widest_sector(points, members, *cover.sheet[0], cover.on[0]).width > border_gap)
      verdict = {PointKind::border, 0, 1, p, {}, {}, 1};
    return verdict;
  }
  if (verdict.kind == PointKind::surface && tolerances.exact())
    if (const auto rim = find_rim(points, sheets, members, cover, least))
      verdict = {PointKind::edge, rim->deviation, 1, p, rim->direction, rim->into, 2};
  return verdict;
}

bool ends_at(std::span<const Vec3> points, std::span<const Sheet> sheets,
             std::span<const std::uint32_t> members, const SheetTolerances& tolerances,
             const SheetOptions& options) {
  const SheetCover cover = cover_neighborhood(points, sheets, members, tolerances);
  const double least = least_deviation(options.sensitivity);
  return cover.count > 0 && find_rim(points, sheets, members, cover, least).has_value();
}

VerdictRows judge_points(std::span<const Vec3> points, const Neighborhoods& neighborhoods,
                         std::span<const Sheet> sheets, const SheetTolerances& tolerances,
                         const SheetOptions& options, const Job& job) {
  const std::size_t k = std::min(tolerances.asked, neighborhoods.k);
  const auto judge = [&](std::size_t begin, std::size_t end, std::vector<FoundVerdict>& found) {
    std::vector<std::uint32_t> members;
    for (std::size_t i = begin; i < end; ++i) {
      const auto row = neighborhoods.of(i).first(k);
      // Most points of most clouds: one sheet for all, and it goes on all around.
      if (explains_all(sheets[i], tolerances) && surrounded(points, i, row, sheets[i])) continue;
      members.assign(1, static_cast<std::uint32_t>(i));
      members.insert(members.end(), row.begin(), row.end());
      const SheetVerdict verdict = judge_point(points, sheets, members, tolerances, options);
      if (!verdict.says_nothing()) found.emplace_back(members[0], verdict);
    }
  };
  return {points.size(),
          parallel_collect<FoundVerdict>(job, points.size(), grain, judge, "detect")};
}

void clean_verdicts(std::span<const Vec3> points, const Neighborhoods& neighborhoods,
                    const Spacing& spacing, const SheetTolerances& tolerances,
                    VerdictRows& verdicts, const Job& job) {
  const auto is_wrong = [&](std::size_t i) {
    if (verdicts[i].kind == PointKind::surface) return false;
    const auto row = neighborhoods.of(i);
    const auto near = row.first(std::min(border_neighbors, row.size()));
    const auto like = std::count_if(near.begin(), near.end(), [&](std::uint32_t j) {
      return sharp(verdicts[i]) ? sharp(verdicts[j]) : verdicts[j].kind == PointKind::border;
    });
    return like < (sharp(verdicts[i]) ? 1 : 2) ||
           overshadowed(points, near, verdicts, static_cast<std::uint32_t>(i), spacing.of_point[i],
                        tolerances);
  };
  for (const std::uint32_t i : parallel_select(job, verdicts.size(), clean_grain, is_wrong))
    verdicts.set(i, {});
}

}  // namespace spigolo
