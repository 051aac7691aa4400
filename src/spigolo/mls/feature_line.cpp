// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mls/feature_line.cpp
#include "spigolo/mls/feature_line.h"

#include <algorithm>
#include <utility>

namespace spigolo {
namespace {

constexpr int newton_steps = 4;

// Moves the two points farthest apart to the front and to the back.
void ends_first_and_last(std::vector<Vec3>& f) {
  std::size_t first = 0, last = 0;
  double longest = 0;
  for (std::size_t i = 0; i < f.size(); ++i)
    for (std::size_t j = i + 1; j < f.size(); ++j) {
      const double d = squared_distance(f[i], f[j]);
      if (d > longest) longest = d, first = i, last = j;
    }
  std::swap(f[0], f[first]);  // last > first, so it is not at 0
  std::swap(f.back(), f[last]);
}

}  // namespace

Vec3 point_at(const FeatureLine& line, double t) {
  const double s = 1 - t;
  return line.b[0] * (s * s * s) + line.b[1] * (3 * s * s * t) + line.b[2] * (3 * s * t * t) +
         line.b[3] * (t * t * t);
}

std::optional<FeatureLine> make_feature_line(std::vector<Vec3>& features) {
  if (features.size() < feature_line_points) return std::nullopt;
  ends_first_and_last(features);
  const Vec3 start = features.front(), end = features.back();
  if (start == end) return std::nullopt;
  const auto inner = features.begin() + 1, behind = features.end() - 1;
  std::stable_sort(inner, behind, [&](const Vec3& a, const Vec3& b) {
    return squared_distance(a, start) < squared_distance(b, start);
  });
  // Before the bisector plane of start and end: the first sector.
  const auto second = std::stable_partition(inner, behind, [&](const Vec3& f) {
    return squared_distance(f, start) <= squared_distance(f, end);
  });
  FeatureLine line{{start, {}, {}, end}};
  line.b[1] = second > inner ? *(inner + (second - inner) / 2) : *second;
  line.b[2] = second < behind ? *(second + (behind - second) / 2) : *(second - 1);
  if (features.size() == feature_line_points) line.b[1] = *inner, line.b[2] = *(inner + 1);
  return line;
}

LineFoot::LineFoot(const FeatureLine& line)
    : power_{line.b[0], (line.b[1] - line.b[0]) * 3, (line.b[2] - line.b[1] * 2 + line.b[0]) * 3,
             line.b[3] - line.b[2] * 3 + line.b[1] * 3 - line.b[0]} {
  for (std::size_t i = 0; i <= pieces; ++i)
    at_piece_[i] = point_at(line, static_cast<double>(i) / pieces);
}

Vec3 LineFoot::nearest(const Vec3& p) const {
  std::size_t best = 0;
  for (std::size_t i = 1; i <= pieces; ++i)
    if (squared_distance(p, at_piece_[i]) < squared_distance(p, at_piece_[best])) best = i;
  const auto at = [&](double t) {
    return power_[0] + (power_[1] + (power_[2] + power_[3] * t) * t) * t;
  };
  // Root of (c(t) - p) c'(t); one piece around the start holds it if the curve is nearly straight.
  const double start = static_cast<double>(best) / pieces, reach = 1.0 / pieces;
  double t = start;
  for (int step = 0; step < newton_steps; ++step) {
    const Vec3 off = at(t) - p;
    const Vec3 d1 = power_[1] + (power_[2] * 2 + power_[3] * (3 * t)) * t;
    const Vec3 d2 = power_[2] * 2 + power_[3] * (6 * t);
    const double slope = std::max(squared_norm(d1) + dot(off, d2), 0.25 * squared_norm(d1));
    if (!(slope > 0)) break;
    t = std::clamp(t - dot(off, d1) / slope, std::max(0.0, start - reach),
                   std::min(1.0, start + reach));
  }
  const Vec3 foot = at(t);
  return squared_distance(p, foot) <= squared_distance(p, at_piece_[best]) ? foot : at_piece_[best];
}

}  // namespace spigolo
