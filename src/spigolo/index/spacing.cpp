// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/index/spacing.cpp
#include "spigolo/index/spacing.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "spigolo/core/parallel.h"

namespace spigolo {
namespace {

constexpr std::size_t spacing_k = 12;
constexpr double line_reach = 0.62;  // [spacings] of both nearest neighbors on a scan line
constexpr double clump = 1e-9;       // of the cloud's spacing: smaller ones are as good as none
constexpr double line_cosine = 0.9;  // between the ways to them, at least
constexpr std::size_t grain = 1 << 14;

// Of numbers that are not negative. Their bits ascend as they do, so a table of the leading ones
// leaves few to choose from.
double median(std::span<const double> values) {
  if (values.empty()) return 0;
  constexpr int leading = 16;
  const auto lead = [](double v) { return std::bit_cast<std::uint64_t>(v) >> (64 - leading); };
  std::vector<std::uint32_t> count(std::size_t{1} << leading);
  for (const double v : values) ++count[lead(v)];
  std::size_t place = values.size() / 2, bucket = 0;
  while (place >= count[bucket]) place -= count[bucket++];
  std::vector<double> inside;
  for (const double v : values)
    if (lead(v) == bucket) inside.push_back(v);
  const auto middle = inside.begin() + static_cast<std::ptrdiff_t>(place);
  std::nth_element(inside.begin(), middle, inside.end());
  return *middle;
}

bool is_on_line(const Vec3& p, const Vec3& a, const Vec3& b, double spacing) {
  const Vec3 to_a = p - a, to_b = p - b;
  const double na = norm(to_a), nb = norm(to_b);
  return nb < line_reach * spacing && dot(to_a, to_b) < -line_cosine * na * nb;
}

}  // namespace

Spacing estimate_spacing(std::span<const Vec3> points, const Neighborhoods& neighborhoods,
                         const Job& job) {
  Spacing spacing;
  spacing.of_point.assign(points.size(), 0.0);
  const std::size_t k = std::min(spacing_k, neighborhoods.k);
  if (k == 0) return spacing;
  // The k-th neighbor sits on the rim of the disc: half of it counts as inside.
  const double disc = pi / (static_cast<double>(k) + 0.5);
  parallel_for(job, "", points.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vec3& rim = points[neighborhoods.of(i)[k - 1]];
      spacing.of_point[i] = std::sqrt(disc * squared_distance(points[i], rim));
    }
  });
  spacing.of_cloud = median(spacing.of_point);
  for (double& s : spacing.of_point) s = std::max(s, clump * spacing.of_cloud);
  if (k < 2) return spacing;
  const std::size_t on_lines = parallel_count(job, points.size(), grain, [&](std::size_t i) {
    const auto row = neighborhoods.of(i);
    return is_on_line(points[i], points[row[0]], points[row[1]], spacing.of_point[i]);
  });
  spacing.on_lines = static_cast<double>(on_lines) / static_cast<double>(points.size());
  return spacing;
}

}  // namespace spigolo
