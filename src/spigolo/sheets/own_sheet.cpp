// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/own_sheet.cpp
#include "spigolo/sheets/own_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "spigolo/core/parallel.h"
#include "spigolo/sheets/consensus.h"
#include "spigolo/sheets/heights.h"
#include "spigolo/sheets/whole_fit.h"

namespace spigolo {
namespace {

constexpr std::size_t grain = 64;
constexpr int growth_rounds = 5;
// Room for rounding and for what a quadric cannot follow, in spacings.
constexpr double smooth_floor = 0.01, plane_floor = 0.1, sheet_floor = 0.06;
// Narrow or tightly bent sheets without noise: what is fitted well enough, and where else to start.
constexpr double sure_fit = 0.02, sure_plane = 0.002;  // [spacings] rms
constexpr int sure_points = 6;                         // of such a plane
constexpr double wider_planes[] = {2, 3, 4.5};         // times the tolerance of a plane
constexpr std::size_t nearest_few[] = {9, 11, 13};     // points, the one itself among them
// A sheet fitted to rounding beats one that is not, if it passes the point exactly.
constexpr double better_fit = 20;                        // times
constexpr double doubtful_fit = 0.005, exact_on = 1e-4;  // [spacings]
constexpr int tighten_rounds = 6;
constexpr double outlying = 3, normal_per_median = 1.4826;  // standard deviations, for a median
constexpr double rounding = 1e-7;                           // [spacings] of exact data
constexpr std::size_t most_points = 128;
constexpr double shifted_fit = 1.1, shifted_height = 0.3;  // of squared residuals and heights
constexpr double mostly_lines = 0.4;                       // share of points on scan lines
constexpr std::size_t lines_k = 48, lines_asked = 40;
constexpr double wide = 2.5;  // standard deviations that hold nearly all points

// Points of another sheet that happen to lie close to this one, just over a crease, bend it a
// little: fit again without what lies far off for the scatter of the others.
Sheet tighten(std::span<const Vec3> points, Sheet sheet, double spacing, std::vector<char>& on) {
  std::array<double, most_points> off, sorted;
  for (int round = 0; round < tighten_rounds; ++round) {
    std::size_t n = 0;
    heights(sheet, points, off.data());
    for (std::size_t t = 0; t < points.size(); ++t) {
      off[t] = std::abs(off[t]);
      if (on[t]) sorted[n++] = off[t];
    }
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(n / 2);
    std::nth_element(sorted.begin(), middle, sorted.begin() + static_cast<std::ptrdiff_t>(n));
    const double limit = std::max(outlying * normal_per_median * *middle, rounding);
    bool changed = false;
    for (std::size_t t = 1; t < points.size(); ++t) {
      if (!on[t] || off[t] <= limit) continue;
      on[t] = 0;
      changed = true;
    }
    if (!changed) break;
    const Sheet tighter = fit_sheet(points, on, spacing, SheetOrder::quadric);
    if (tighter.support < 6) break;
    sheet = tighter;
  }
  return sheet;
}

// Fit, take in all points on the fit, fit again until nothing changes; a bent start is a quadric.
Sheet grow(std::span<const Vec3> points, double spacing, const SheetTolerances& tolerances,
           std::vector<char>& on, SheetOrder start) {
  std::array<double, most_points> off;
  Sheet sheet;
  for (int round = 0; round < growth_rounds; ++round) {
    const SheetOrder order = round == 0 ? start : SheetOrder::quadric;
    sheet = fit_sheet(points, on, spacing, order);
    if (!sheet.fitted()) return sheet;
    const bool curved = order == SheetOrder::quadric && sheet.support >= quadric_points;
    const double limit = curved ? tolerances.on_sheet() : tolerances.plane();
    heights(sheet, points, off.data());
    bool changed = false;
    for (std::size_t t = 1; t < points.size(); ++t) {  // the point itself stays on its sheet
      const char is_on = std::abs(off[t]) < limit;
      changed |= is_on != std::exchange(on[t], is_on);
    }
    if (round >= 2 && !changed) break;
  }
  return sheet;
}

Sheet grow_tightly(std::span<const Vec3> points, double spacing, const SheetTolerances& tolerances,
                   std::vector<char>& on, SheetOrder start) {
  const Sheet grown = grow(points, spacing, tolerances, on, start);
  return grown.fitted() ? tighten(points, grown, spacing, on) : grown;
}

// From the points within `tolerance` [units] of the plane that most of them agree with.
Sheet grow_from_plane(std::span<const Vec3> points, double spacing,
                      const SheetTolerances& tolerances, double tolerance, SheetOrder start,
                      std::vector<char>& scratch) {
  const Vec3 normal = consensus_plane(points, tolerance);
  if (normal == Vec3{}) return {};
  scratch.resize(points.size());
  for (std::size_t t = 0; t < points.size(); ++t)
    scratch[t] = std::abs(dot(normal, points[t] - points[0])) < tolerance;
  return grow_tightly(points, spacing, tolerances, scratch, start);
}

bool sure(const Sheet& sheet) {
  if (sheet.support >= quadric_points) return sheet.deviation <= sure_fit;
  return sheet.support >= sure_points && sheet.deviation <= sure_plane;
}

// Where the plane's points make no sheet, the surface bends too much or another piece lies too
// close: begin with more of them, bent, or with the nearest few alone.
Sheet try_harder(std::span<const Vec3> points, double spacing, const SheetTolerances& tolerances,
                 Sheet best, std::vector<char>& scratch) {
  const auto offer = [&](const Sheet& sheet) {
    if (sure(sheet) && (!sure(best) || sheet.support > best.support)) best = sheet;
  };
  for (const double wider : wider_planes)
    offer(grow_from_plane(points, spacing, tolerances, wider * tolerances.plane() * spacing,
                          SheetOrder::quadric, scratch));
  for (const std::size_t few : nearest_few) {
    if (few > points.size()) break;
    scratch.assign(points.size(), 0);
    std::fill_n(scratch.begin(), few, char{1});
    if (fit_sheet(points, scratch, spacing, SheetOrder::quadric).deviation <= sure_fit)
      offer(grow_tightly(points, spacing, tolerances, scratch, SheetOrder::quadric));
  }
  return best;
}

// Exactly sampled flats that run through a point know it better than its own fit across a crease.
const Sheet* find_exact_sheet(const Vec3& p, std::span<const std::uint32_t> row,
                              std::span<const Sheet> first, const Sheet& own) {
  if (own.whole || own.deviation < doubtful_fit) return nullptr;
  const double limit = own.deviation / better_fit;
  const Sheet* best = nullptr;
  for (const std::uint32_t j : row) {
    const Sheet& s = first[j];
    if (s.support >= quadric_points && s.deviation <= limit &&
        (!best || s.support > best->support) &&
        std::abs(height(s, p)) <= std::max(exact_on, 2 * s.deviation))
      best = &s;
  }
  return best;
}

// With noise: beside a crease the neighborhood of some neighbor, farther from it, lies on the
// point's sheet alone. Of those whose fit passes the point, the best one; none if all are poor.
const Sheet* take_from_neighbors(const Vec3& p, std::span<const std::uint32_t> row,
                                 std::span<const Sheet> whole, const SheetTolerances& tolerances) {
  const double noise2 = tolerances.noise * tolerances.noise;
  double least = shifted_fit * noise2;
  const Sheet* best = nullptr;
  for (const std::uint32_t j : row) {
    const double deviation2 = whole[j].deviation * whole[j].deviation;
    if (!(deviation2 < least)) continue;
    const double h = height(whole[j], p);
    const double score = deviation2 + shifted_height * h * h;
    if (score < least) least = score, best = &whole[j];
  }
  return best;
}

}  // namespace

double SheetTolerances::smooth() const { return std::max(smooth_floor, 1.15 * noise); }
double SheetTolerances::plane() const { return std::max(plane_floor, wide * noise); }
double SheetTolerances::on_sheet() const { return std::max(sheet_floor, wide * noise); }

SheetTolerances sheet_tolerances(double noise, double on_lines) {
  struct Row {
    double below;  // [spacings]
    std::size_t k, asked;
  };
  constexpr Row rows[] = {
      {0.03, 20, 16}, {0.1, 24, 20}, {0.15, 40, 32}, {0.3, 64, 48}, {infinity, 96, 64}};
  const Row& row = *std::find_if(std::begin(rows), std::end(rows),
                                 [&](const Row& r) { return noise < r.below; });
  SheetTolerances tolerances{noise, row.k, row.asked, on_lines > mostly_lines};
  if (tolerances.on_lines) {
    tolerances.k = std::max(tolerances.k, lines_k);
    tolerances.asked = std::max(tolerances.asked, lines_asked);
  }
  return tolerances;
}

Sheet find_own_sheet(std::span<const Vec3> points, double spacing,
                     const SheetTolerances& tolerances, std::vector<char>& scratch) {
  Sheet whole = fit_sheet(points, {}, spacing, SheetOrder::quadric);
  whole.whole = whole.deviation < tolerances.smooth();
  return whole.whole ? whole : find_part_sheet(points, spacing, tolerances, scratch);
}

Sheet find_part_sheet(std::span<const Vec3> points, double spacing,
                      const SheetTolerances& tolerances, std::vector<char>& scratch) {
  const Sheet sheet = grow_from_plane(points, spacing, tolerances, tolerances.plane() * spacing,
                                      SheetOrder::plane, scratch);
  return tolerances.exact() && !sure(sheet)
             ? try_harder(points, spacing, tolerances, sheet, scratch)
             : sheet;
}

std::vector<Sheet> find_own_sheets(std::span<const Vec3> points, const Neighborhoods& neighborhoods,
                                   const Spacing& spacing, const SheetTolerances& tolerances,
                                   const Job& job) {
  using Better = std::pair<std::uint32_t, Sheet>;
  const bool exact = tolerances.exact();
  const std::size_t k = std::min(tolerances.k, neighborhoods.k);
  const auto part = [&](std::size_t i, std::vector<Vec3>& around, std::vector<char>& scratch) {
    around.assign(1, points[i]);
    for (const std::uint32_t j : neighborhoods.of(i).first(k)) around.push_back(points[j]);
    return find_part_sheet(around, spacing.of_point[i], tolerances, scratch);
  };
  auto sheets = parallel_array<Sheet>(job, points.size());
  parallel_for(job, "sheets", points.size(), grain, [&](std::size_t begin, std::size_t end) {
    fit_whole_sheets({points, neighborhoods, spacing, k}, begin, end, &sheets[begin]);
    std::vector<Vec3> around;
    std::vector<char> scratch;
    for (std::size_t i = begin; i < end; ++i) {
      sheets[i].whole = sheets[i].deviation < tolerances.smooth();
      if (exact && !sheets[i].whole) sheets[i] = part(i, around, scratch);
    }
  });
  // All of them look at the first sheets of the others; few are better.
  const auto better = parallel_collect<Better>(
      job, points.size(), grain, [&](std::size_t begin, std::size_t end, auto& found) {
        std::vector<Vec3> around;
        std::vector<char> scratch;
        for (std::size_t i = begin; i < end; ++i) {
          if (sheets[i].whole) continue;
          const auto row = neighborhoods.of(i).first(k);
          const Sheet* best = exact ? find_exact_sheet(points[i], row, sheets, sheets[i])
                                    : take_from_neighbors(points[i], row, sheets, tolerances);
          if (!exact || best)
            found.emplace_back(static_cast<std::uint32_t>(i),
                               best ? *best : part(i, around, scratch));
        }
      });
  for (const auto& [i, sheet] : better) {
    sheets[i] = sheet;
    sheets[i].whole = false;
  }
  return sheets;
}

}  // namespace spigolo
