// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/chains.cpp
#include "spigolo/sheets/chains.h"

#include <algorithm>
#include <cmath>

namespace spigolo {
namespace {

constexpr double quiet = 0.1;    // [spacings] of noise: less feigns no edges
constexpr double link = 2.5;     // [spacings] from one to the next
constexpr double long_link = 5;  // [spacings] the same along one crease, as on scan lines
constexpr double aligned = 0.95, beside = 0.4;  // cosine of two creases, [spacings] between them
constexpr double shortest = 4;                  // [spacings] from end to end
constexpr std::size_t surely_long = 64;         // points of a chain that need no measuring

bool sharp(const SheetVerdict& v) {
  return v.kind == PointKind::edge || v.kind == PointKind::corner;
}

bool connected(std::span<const Vec3> points, const VerdictRows& verdicts, std::uint32_t i,
               std::uint32_t j, double spacing) {
  const double away = distance(points[i], points[j]);
  if (away <= link * spacing) return true;
  const SheetVerdict &a = verdicts[i], &b = verdicts[j];
  if (away > long_link * spacing || std::abs(dot(a.direction, b.direction)) < aligned) return false;
  const Vec3 off = b.crease_point - a.crease_point;
  return norm(off - a.direction * dot(off, a.direction)) < beside * spacing;
}

// The marked points that are connected to the first one, as they are reached; at most surely_long.
std::vector<std::uint32_t> chain_from(std::uint32_t first, std::span<const Vec3> points,
                                      const Neighborhoods& neighborhoods, const Spacing& spacing,
                                      const VerdictRows& verdicts,
                                      std::vector<std::uint32_t>& reached_from) {
  std::vector<std::uint32_t> chain(1, first);
  reached_from[first] = first;
  for (std::size_t at = 0; at < chain.size(); ++at) {
    const std::uint32_t i = chain[at];
    for (const std::uint32_t j : neighborhoods.of(i)) {
      if (!sharp(verdicts[j]) || reached_from[j] == first ||
          !connected(points, verdicts, i, j, spacing.of_point[i]))
        continue;
      reached_from[j] = first;
      chain.push_back(j);
      if (chain.size() == surely_long) return chain;
    }
  }
  return chain;
}

bool is_long(std::span<const std::uint32_t> chain, std::span<const Vec3> points, double spacing) {
  if (chain.size() >= surely_long) return true;
  for (const std::uint32_t i : chain)
    for (const std::uint32_t j : chain)
      if (distance(points[i], points[j]) >= shortest * spacing) return true;
  return false;
}

}  // namespace

void drop_short_chains(std::span<const Vec3> points, const Neighborhoods& neighborhoods,
                       const Spacing& spacing, double noise, VerdictRows& verdicts,
                       const Job& job) {
  if (noise < quiet) return;
  job.check();
  std::vector<std::uint32_t> reached_from(points.size(), no_point), dropped;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (!sharp(verdicts[i])) continue;
    const auto chain = chain_from(i, points, neighborhoods, spacing, verdicts, reached_from);
    if (!is_long(chain, points, spacing.of_point[i])) dropped.push_back(i);
  }
  for (const std::uint32_t i : dropped) verdicts.set(i, {});
}

}  // namespace spigolo
