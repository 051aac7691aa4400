// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/cover.cpp
#include "spigolo/sheets/cover.h"

#include <algorithm>
#include <cmath>

#include "spigolo/sheets/heights.h"

namespace spigolo {
namespace {

constexpr std::size_t least_gain = 3;                // neighbors that a further sheet must explain
constexpr double on_floor = 0.08, wide = 2.5;        // [spacings], [standard deviations]
constexpr double rounding = 1e-6;                    // [spacings]
constexpr double good_floor = 0.06, good_fit = 1.5;  // the same, of a sheet's residuals
constexpr double exact_good = 0.03;                  // [spacings] without noise

// How well a sheet fits, with all that differs by rounding alike: no verdict may hang on that.
double fit_of(const Sheet& sheet) { return std::max(sheet.deviation, rounding); }

PointSet points_on(const Sheet& sheet, std::span<const Vec3> around, double limit) {
  std::array<double, max_cover_points> off;
  heights(sheet, around, off.data());
  PointSet on;
  for (std::size_t m = 0; m < around.size(); ++m) on[m] = std::abs(off[m]) < limit;
  return on;
}

// Close to a crease a sheet may hold a point of the next one. Of the sheets of the neighbors on it,
// the one that fits best and explains nearly the same points takes its place.
void take_best_fits(std::span<const Vec3> around, std::span<const Sheet> sheets,
                    std::span<const std::uint32_t> members, double limit, SheetCover& cover) {
  for (std::size_t c = 0; c < cover.count; ++c) {
    const PointSet mine = cover.on[c];
    for (std::size_t m = 0; m < members.size(); ++m) {
      const Sheet& sheet = sheets[members[m]];
      if (!mine[m] || !sheet.fitted() || fit_of(sheet) >= fit_of(*cover.sheet[c])) continue;
      const PointSet on = points_on(sheet, around, limit);
      if ((on & mine).count() * 10 < mine.count() * 8) continue;
      cover.sheet[c] = &sheet;
      cover.on[c] = on;
    }
  }
}

// [spacings] Points this close to a sheet are on it.
double on_limit(const SheetTolerances& tolerances) {
  return std::max(on_floor, wide * tolerances.noise);
}

}  // namespace

bool explains_all(const Sheet& own, const SheetTolerances& tolerances) {
  // deviation^2 * (support - freedom) is the sum of all squared heights, so none is larger.
  const double farthest = own.deviation * std::sqrt(static_cast<double>(own.support));
  return own.whole && farthest < on_limit(tolerances);
}

SheetCover cover_neighborhood(std::span<const Vec3> points, std::span<const Sheet> sheets,
                              std::span<const std::uint32_t> members,
                              const SheetTolerances& tolerances) {
  SheetCover cover;
  const double limit = on_limit(tolerances);
  const double good =
      std::max(tolerances.exact() ? exact_good : good_floor, good_fit * tolerances.noise);
  std::array<Vec3, max_cover_points> place;
  for (std::size_t m = 0; m < members.size(); ++m) place[m] = points[members[m]];
  const std::span<const Vec3> around(place.data(), members.size());
  PointSet left;
  for (std::size_t m = 0; m < members.size(); ++m) left.set(m);
  const auto add = [&](const Sheet& sheet, const PointSet& on) {
    cover.sheet[cover.count] = &sheet;
    cover.on[cover.count++] = on;
    left &= ~on;
  };
  const Sheet& own = sheets[members[0]];
  if (own.fitted()) add(own, points_on(own, around, limit));
  while (cover.count > 0 && cover.count < SheetCover::most && left.any()) {
    std::size_t best_gain = 0;
    const Sheet* best = nullptr;
    PointSet best_on;
    for (std::size_t m = 1; m < members.size(); ++m) {
      const Sheet& sheet = sheets[members[m]];
      if (!left[m] || !sheet.fitted() || sheet.deviation > good) continue;
      const PointSet on = points_on(sheet, around, limit);
      const std::size_t gain = (on & left).count();
      if (gain < best_gain || (gain == best_gain && best && fit_of(sheet) >= fit_of(*best)))
        continue;
      best_gain = gain, best = &sheet, best_on = on;
    }
    if (best_gain < least_gain) break;
    add(*best, best_on);
  }
  cover.unexplained = left.count();
  if (tolerances.exact() && cover.count > 1) take_best_fits(around, sheets, members, limit, cover);
  return cover;
}

}  // namespace spigolo
