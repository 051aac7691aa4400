// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/gaps.cpp
#include "spigolo/sheets/gaps.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "spigolo/core/parallel.h"

namespace spigolo {
namespace {

constexpr double half = 0.55;       // [spacings] so close a crease passes the point
constexpr double placed = 0.1;      // [spacings] where samples were put on the edges
constexpr double longest = 4;       // [spacings] between the two
constexpr double aligned = 0.94;    // cosine, of a crease with the line between them
constexpr double alike = 0.35;      // [rad] the two angles from flat may differ
constexpr double fill_trust = 0.9;  // of the strength of the two
constexpr std::size_t asked = 20;   // neighbors
constexpr std::size_t grain = 4096;

std::optional<SheetVerdict> between(const SheetVerdict& a, const SheetVerdict& b, const Vec3& p,
                                    double spacing, double reach) {
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
  if (distance(foot, p) > reach * spacing) return std::nullopt;
  SheetVerdict filled = t < 0.5 ? a : b;
  filled.crease_point = foot;
  filled.direction = along;
  filled.deviation = a.deviation + (b.deviation - a.deviation) * t;
  filled.strength = std::min(a.strength, b.strength) * fill_trust;
  return filled;
}

// The closest crease between two of these edges that passes p, unless another edge is closer to it.
std::optional<SheetVerdict> filled_between(std::span<const Vec3> points, const Vec3& p,
                                           std::span<const std::uint32_t> edges,
                                           const VerdictRows& verdicts, double spacing,
                                           double reach) {
  std::optional<SheetVerdict> best;
  for (std::size_t a = 0; a < edges.size(); ++a) {
    for (std::size_t b = a + 1; b < edges.size(); ++b) {
      const auto found = between(verdicts[edges[a]], verdicts[edges[b]], p, spacing, reach);
      if (!found) continue;
      const double away = distance(found->crease_point, p);
      const bool taken = std::any_of(edges.begin(), edges.end(), [&](std::uint32_t j) {
        return distance(points[j], found->crease_point) < away;
      });
      if (!taken && (!best || away < distance(best->crease_point, p))) best = found;
    }
  }
  return best;
}

}  // namespace

void fill_gaps(std::span<const Vec3> points, const Neighborhoods& neighborhoods,
               const Spacing& spacing, bool on_edges, VerdictRows& verdicts, const Job& job) {
  const double reach = on_edges ? placed : half;
  // Looked up twenty times a point: apart from the verdicts they stay in the cache.
  std::vector<PointKind> kind(points.size());
  parallel_for(job, "", points.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) kind[i] = verdicts[i].kind;
  });
  const auto look = [&](std::size_t begin, std::size_t end, std::vector<FoundVerdict>& filled) {
    std::vector<std::uint32_t> edges;
    for (std::size_t i = begin; i < end; ++i) {
      if (kind[i] != PointKind::surface) continue;
      edges.clear();
      const auto row = neighborhoods.of(i);
      for (const std::uint32_t j : row.first(std::min(asked, row.size())))
        if (kind[j] == PointKind::edge) edges.push_back(j);
      if (edges.size() < 2) continue;
      const auto best =
          filled_between(points, points[i], edges, verdicts, spacing.of_point[i], reach);
      if (best) filled.emplace_back(static_cast<std::uint32_t>(i), *best);
    }
  };
  verdicts.set(parallel_collect<FoundVerdict>(job, points.size(), grain, look));
}

}  // namespace spigolo
