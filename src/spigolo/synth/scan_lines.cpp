// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/scan_lines.cpp - samples along the cuts of a shape with parallel planes
#include <optional>

#include "spigolo/synth/point_grid.h"
#include "spigolo/synth/sampling.h"

namespace spigolo {
namespace {

constexpr double denser = 4;                 // along than across
constexpr double least_step = 0.65;          // share of the mean step; random steps can reach .74
constexpr std::size_t darts_per_point = 60;  // before the least step shrinks
constexpr double shrink = 0.95;
constexpr std::size_t stop_check = 1024;
constexpr std::size_t probes = 2000;
constexpr int secant_steps = 20;
constexpr double on_plane = 1e-9;  // share of the radius; the samples lie on the surface exactly

/// Across the planes: askew to the axes, along which most shapes are built.
Vec3 plane_normal() { return normalized({1, 0.7, 0.45}); }

/// How far the surface runs along d per length in its steepest direction: sin of the angle between
/// d and the normal.
double slope(const Patch& patch, const Vec3& p, const Vec3& d, double step) {
  return std::sqrt(std::max(0.0, dot(patch.nearest(p + step * d) - p, d) / step));
}

/// Length of all lines times their distance: the area seen along d.
double cut_area(const Shape& shape, const Vec3& d) {
  Random random(1);
  const Sampler sampler(shape);
  double sum = 0;
  for (std::size_t i = 0; i < probes; ++i) {
    const Patch& patch = shape.patches[sampler.patch(random)];
    sum += slope(patch, patch.sample(random), d, 1e-6 * shape.radius);
  }
  return area(shape) * sum / probes;
}

/// The patch point near p where d * x = level, found by moving p along d (secant rule); none if the
/// patch ends before.
std::optional<Vec3> snap(const Patch& patch, const Vec3& p, const Vec3& d, double level,
                         double rounding) {
  double t0 = 0, f0 = dot(p, d) - level, t1 = -f0;
  if (std::abs(f0) <= rounding) return p;
  for (int i = 0; i < secant_steps; ++i) {
    const Vec3 q = patch.nearest(p + t1 * d);
    const double f1 = dot(q, d) - level;
    if (std::abs(f1) <= rounding) return q;
    if (f1 == f0) return std::nullopt;
    const double t = t1 - f1 * (t1 - t0) / (f1 - f0);
    t0 = t1, f0 = f1, t1 = t;
  }
  return std::nullopt;
}

}  // namespace

ScanLines sample_scan(const Shape& shape, std::size_t count, Random& random, const Job& job) {
  ScanLines lines;
  if (count == 0) return lines;
  const Sampler sampler(shape);
  const Vec3 d = plane_normal();
  lines.along = std::sqrt(cut_area(shape, d) / denser / static_cast<double>(count));
  lines.across = denser * lines.along;
  double r = least_step * lines.along;
  const double offset = random.uniform(0, lines.across);
  PointGrid grid(2 * r, count);
  for (std::size_t dart = 1; grid.points().size() < count; ++dart) {
    if (dart % stop_check == 0) job.check();
    if (dart % (darts_per_point * count) == 0) r *= shrink;
    const Patch& patch = shape.patches[sampler.patch(random)];
    const Vec3 p = patch.sample(random);
    const double line = std::round((dot(p, d) - offset) / lines.across);
    const auto q = snap(patch, p, d, offset + line * lines.across, on_plane * shape.radius);
    if (q && !grid.any_within(*q, r)) grid.insert(*q);
  }
  lines.points = grid.points();
  return lines;
}

}  // namespace spigolo
