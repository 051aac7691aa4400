// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/gaps.cpp
#include "spigolo/sheets/gaps.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace spigolo {
namespace {

constexpr double half = 0.55;       // [spacings] so close a crease passes the point
constexpr double longest = 4;       // [spacings] between the two
constexpr double aligned = 0.94;    // cosine, of a crease with the line between them
constexpr double alike = 0.35;      // [rad] the two angles from flat may differ
constexpr double fill_trust = 0.9;  // of the strength of the two
constexpr std::size_t asked = 20;   // neighbors

std::optional<SheetVerdict> between(const SheetVerdict& a, const SheetVerdict& b, const Vec3& p,
                                    double spacing) {
  const Vec3 line = b.crease_point - a.crease_point;
  const double length = norm(line);
  if (!(length > 0.5 * spacing) || length > longest * spacing) return std::nullopt;
  const Vec3 along = line / length;
  if (std::abs(dot(a.direction, along)) < aligned || std::abs(dot(b.direction, along)) < aligned ||
      std::abs(a.deviation - b.deviation) > alike)
    return std::nullopt;
  const double t = dot(p - a.crease_point, along) / length;
  if (t <= 0 || t >= 1) return std::nullopt;
  const Vec3 foot = a.crease_point + line * t;
  if (distance(foot, p) > half * spacing) return std::nullopt;
  SheetVerdict filled = t < 0.5 ? a : b;
  filled.crease_point = foot;
  filled.direction = along;
  filled.deviation = a.deviation + (b.deviation - a.deviation) * t;
  filled.strength = std::min(a.strength, b.strength) * fill_trust;
  return filled;
}

}  // namespace

void fill_gaps(std::span<const Vec3> points, const Neighborhoods& neighborhoods,
               const Spacing& spacing, std::vector<SheetVerdict>& verdicts) {
  std::vector<std::pair<std::uint32_t, SheetVerdict>> filled;
  std::vector<std::uint32_t> edges;
  for (std::uint32_t i = 0; i < verdicts.size(); ++i) {
    if (verdicts[i].kind != PointKind::surface) continue;
    edges.clear();
    const auto row = neighborhoods.of(i);
    for (const std::uint32_t j : row.first(std::min(asked, row.size())))
      if (verdicts[j].kind == PointKind::edge) edges.push_back(j);
    std::optional<SheetVerdict> best;
    for (std::size_t a = 0; a < edges.size(); ++a) {
      for (std::size_t b = a + 1; b < edges.size(); ++b) {
        const auto found =
            between(verdicts[edges[a]], verdicts[edges[b]], points[i], spacing.of_point[i]);
        if (!found) continue;
        const double away = distance(found->crease_point, points[i]);
        const bool taken = std::any_of(edges.begin(), edges.end(), [&](std::uint32_t j) {
          return distance(points[j], found->crease_point) < away;
        });
        if (!taken && (!best || away < distance(best->crease_point, points[i]))) best = found;
      }
    }
    if (best) filled.emplace_back(i, *best);
  }
  for (const auto& [i, verdict] : filled) verdicts[i] = verdict;
}

}  // namespace spigolo
