// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/chains.cpp
#include "spigolo/sheets/chains.h"

#include <algorithm>

namespace spigolo {
namespace {

constexpr double quiet = 0.1;            // [spacings] of noise: less feigns no edges
constexpr std::size_t asked = 24;        // neighbors that may be the next of a chain
constexpr double link = 2.5;             // [spacings] from one to the next
constexpr double shortest = 4;           // [spacings] from end to end
constexpr std::size_t surely_long = 64;  // points of a chain that need no measuring

bool sharp(const SheetVerdict& v) {
  return v.kind == PointKind::edge || v.kind == PointKind::corner;
}

// The marked points that are connected to the first one, as they are reached; at most surely_long.
std::vector<std::uint32_t> chain_from(std::uint32_t first, std::span<const Vec3> points,
                                      const Neighborhoods& neighborhoods, const Spacing& spacing,
                                      std::span<const SheetVerdict> verdicts,
                                      std::vector<std::uint32_t>& reached_from) {
  std::vector<std::uint32_t> chain(1, first);
  reached_from[first] = first;
  for (std::size_t at = 0; at < chain.size(); ++at) {
    const std::uint32_t i = chain[at];
    const auto row = neighborhoods.of(i);
    for (const std::uint32_t j : row.first(std::min(asked, row.size()))) {
      if (!sharp(verdicts[j]) || reached_from[j] == first ||
          distance(points[i], points[j]) > link * spacing.of_point[i])
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
                       const Spacing& spacing, double noise, std::vector<SheetVerdict>& verdicts,
                       const Job& job) {
  if (noise < quiet) return;
  job.check();
  std::vector<std::uint32_t> reached_from(points.size(), no_point), dropped;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (!sharp(verdicts[i])) continue;
    const auto chain = chain_from(i, points, neighborhoods, spacing, verdicts, reached_from);
    if (!is_long(chain, points, spacing.of_point[i])) dropped.push_back(i);
  }
  for (const std::uint32_t i : dropped) verdicts[i] = {};
}

}  // namespace spigolo
