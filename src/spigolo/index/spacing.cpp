// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/index/spacing.cpp
#include "spigolo/index/spacing.h"

#include <algorithm>
#include <cmath>

#include "spigolo/core/parallel.h"

namespace spigolo {
namespace {

constexpr std::size_t spacing_k = 12;
constexpr double line_reach = 0.62;  // [spacings] of both nearest neighbors on a scan line
constexpr double line_cosine = 0.9;  // between the ways to them, at least
constexpr std::size_t grain = 1 << 14;

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
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
  std::size_t on_lines = 0;
  for (std::size_t i = 0; k >= 2 && i < points.size(); ++i) {
    const auto row = neighborhoods.of(i);
    on_lines += is_on_line(points[i], points[row[0]], points[row[1]], spacing.of_point[i]);
  }
  spacing.on_lines = static_cast<double>(on_lines) / static_cast<double>(points.size());
  return spacing;
}

}  // namespace spigolo
