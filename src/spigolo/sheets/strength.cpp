// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/strength.cpp
#include "spigolo/sheets/strength.h"

#include <algorithm>
#include <cmath>

#include "spigolo/core/parallel.h"

namespace spigolo {
namespace {

constexpr std::size_t grain = 4096;
constexpr std::size_t asked = 16;    // neighbors
constexpr double most_alike = 6;     // of them count
constexpr double clear_angle = 1.2;  // [rad] from flat; more adds nothing
constexpr double least = 0.01;       // a marked point is never rated as surface

bool sharp(const SheetVerdict& v) {
  return v.kind == PointKind::edge || v.kind == PointKind::corner;
}

// Coefficients of the logistic model, one fit to 19 005 marked points.
double log_odds(double noise, double away, double angle, double alike, bool corner) {
  return -0.346 - 4.891 * noise + (10.471 * noise - 7.208) * away +
         (5.941 - 5.582 * noise) * angle + (0.07 + 0.295 * noise) * alike + (corner ? 2.343 : 0);
}

}  // namespace

void rate_verdicts(const SheetCloud& cloud, const SheetTolerances& tolerances,
                   VerdictRows& verdicts, const Job& job) {
  const auto marked = parallel_select(job, verdicts.size(), grain,
                                      [&](std::size_t i) { return sharp(verdicts[i]); });
  for (const std::uint32_t i : marked) {
    SheetVerdict& verdict = verdicts.edit(i);
    const auto row = cloud.neighborhoods.of(i);
    const auto near = row.first(std::min(asked, row.size()));
    const auto alike = static_cast<double>(std::count_if(
        near.begin(), near.end(), [&](std::uint32_t j) { return sharp(verdicts[j]); }));
    const double away = distance(cloud.points[i], verdict.crease_point) / cloud.spacing.of_point[i];
    const double odds = log_odds(tolerances.noise, away, std::min(verdict.deviation, clear_angle),
                                 std::min(alike, most_alike), verdict.kind == PointKind::corner);
    verdict.strength = std::max(least, 1 / (1 + std::exp(-odds)));
  }
}

}  // namespace spigolo
