// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/measure.cpp
#include "spigolo/blend/measure.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "spigolo/core/parallel.h"

namespace spigolo {
namespace {

// Lengths in spacings.
constexpr double probe_step = 0.5;
constexpr double longest_wave = 8;
constexpr std::array<double, 3> probed_shares = {0.25, 0.5, 0.75};
constexpr std::size_t grain = 8;
constexpr std::size_t profile_every = 4;  // strands
constexpr int beyond_border = 3;          // probe steps

// The MLS surface of everything.
class Union {
 public:
  Union(std::span<const Vec3> points, const CloudSide& cloud, const Job& job)
      : mls_(points, job), options_(cloud.options()) {}

  SurfacePoint project(const Vec3& p, MlsScratch& scratch) const {
    return project_plain(mls_, p, options_, scratch);
  }
  /// Distance to the nearest point, or to the next one after a point itself.
  double nearest(const Vec3& p, std::size_t rank, MlsScratch& scratch) const {
    mls_.tree().nearest(p - mls_.origin(), rank + 1, scratch.found);
    return std::sqrt(scratch.found.back().squared_distance);
  }

 private:
  MlsCloud mls_;
  MlsOptions options_;
};

// Places at even distances along the collar at one share of its width.
std::vector<Vec3> probe_line(const BorderLoop& loop, const CollarPlace& place, double share,
                             double step) {
  const std::size_t n = loop.strands.size(), rows = loop.closed ? n : n - 1;
  std::vector<Vec3> points = {place(0, share)};
  double rest = step;
  Vec3 last = points.front();
  for (std::size_t i = 0; i < rows; ++i)
    for (int part = 1; part <= 4; ++part) {
      const Vec3 next = place(static_cast<double>(i) + part / 4.0, share);
      double length = distance(last, next);
      while (length >= rest && length > 0) {
        last = last + (next - last) * (rest / length);
        points.push_back(last);
        length = distance(last, next);
        rest = step;
      }
      rest -= length;
      last = next;
    }
  return points;
}

// Mean square of what a moving average of the longest wave leaves.
double high_pass(const std::vector<double>& height, std::size_t window, bool closed) {
  const auto n = static_cast<std::ptrdiff_t>(height.size());
  const auto half = static_cast<std::ptrdiff_t>(window / 2);
  double squares = 0;
  std::size_t used = 0;
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    if (!closed && (i < half || i + half >= n)) continue;
    double sum = 0;
    for (std::ptrdiff_t k = -half; k <= half; ++k)
      sum += height[static_cast<std::size_t>(((i + k) % n + n) % n)];
    const double wave =
        height[static_cast<std::size_t>(i)] - sum / static_cast<double>(2 * half + 1);
    squares += wave * wave;
    ++used;
  }
  return used > 0 ? squares / static_cast<double>(used) : 0;
}

// Height of the MLS surface over each place of a line, across the collar.
std::vector<double> heights(const Union& all, const std::vector<Vec3>& line, const Job& job) {
  std::vector<double> height(line.size(), 0);
  std::vector<Vec3> normal(line.size());
  parallel_for(job, "", line.size(), grain, [&](std::size_t begin, std::size_t end) {
    MlsScratch scratch;
    for (std::size_t i = begin; i < end; ++i) {
      const SurfacePoint foot = all.project(line[i], scratch);
      if (!on_surface(foot.status)) continue;
      normal[i] = foot.normal;
      height[i] = dot(foot.position - line[i], foot.normal);
    }
  });
  for (std::size_t i = 1; i < line.size(); ++i)  // one sign for all
    if (dot(normal[i], normal[i - 1]) < 0) normal[i] = -normal[i], height[i] = -height[i];
  return height;
}

double ripple_of(const Union& all, const BorderLoop& loop, const CollarPlace& place, double spacing,
                 const Job& job) {
  double squares = 0;
  for (const double share : probed_shares) {
    const std::vector<Vec3> line = probe_line(loop, place, share, probe_step * spacing);
    const auto window = static_cast<std::size_t>(longest_wave / probe_step);
    if (line.size() > 2 * window)
      squares += high_pass(heights(all, line, job), window, loop.closed);
  }
  return std::sqrt(squares / probed_shares.size()) / spacing;
}

double gap_of(const Union& all, const BorderLoop& loop, const CollarPlace& place, double spacing,
              const Job& job) {
  double across = 0;
  for (const Strand& s : loop.strands)
    across = std::max(across, distance(s.alpha, s.x) + distance(s.x, s.beta));
  const int lines = std::max(2, static_cast<int>(across / (probe_step * spacing)));
  std::vector<double> gap(static_cast<std::size_t>(lines) + 1, 0);
  parallel_for(job, "", gap.size(), 1, [&](std::size_t begin, std::size_t end) {
    MlsScratch scratch;
    for (std::size_t i = begin; i < end; ++i)
      for (const Vec3& p :
           probe_line(loop, place, static_cast<double>(i) / lines, probe_step * spacing))
        gap[i] = std::max(gap[i], all.nearest(p, 0, scratch));
  });
  return *std::max_element(gap.begin(), gap.end()) / spacing;
}

void measure_borders(const Union& all, const BorderLoop& loop, CollarQuality& quality) {
  MlsScratch scratch;
  for (const Strand& s : loop.strands) {
    const SurfacePoint on_face = all.project(s.alpha, scratch);
    if (on_surface(on_face.status))
      quality.face_error.add(axial_angle(on_face.normal, s.alpha_normal));
    const SurfacePoint on_cloud = all.project(s.beta, scratch);
    if (on_surface(on_cloud.status))
      quality.cloud_error.add(axial_angle(on_cloud.normal, s.beta_normal));
  }
}

// From a little before alpha to a little behind beta, on the surface of everything.
std::vector<Vec3> profile(const BorderLoop& loop, const CollarPlace& place, std::size_t i,
                          double step) {
  const Strand& s = loop.strands[i];
  const double length = distance(s.alpha, s.x) + distance(s.x, s.beta);
  const int steps = std::max(2, static_cast<int>(length / step));
  const Vec3 out_face = -normalized(s.alpha_handle), out_cloud = -normalized(s.beta_handle);
  std::vector<Vec3> points;
  for (int k = beyond_border; k > 0; --k) points.push_back(s.alpha + out_face * (k * step));
  for (int k = 0; k <= steps; ++k)
    points.push_back(place(static_cast<double>(i), static_cast<double>(k) / steps));
  for (int k = 1; k <= beyond_border; ++k) points.push_back(s.beta + out_cloud * (k * step));
  return points;
}

double largest_turn(const Union& all, const std::vector<Vec3>& points, double spacing) {
  MlsScratch scratch;
  std::vector<SurfacePoint> feet;
  for (const Vec3& p : points) {
    const SurfacePoint foot = all.project(p, scratch);
    if (on_surface(foot.status)) feet.push_back(foot);
  }
  double largest = 0;
  for (std::size_t i = 2; i < feet.size(); ++i) {
    const double way = distance(feet[i].position, feet[i - 2].position);
    if (way < 0.25 * spacing) continue;
    largest = std::max(largest, axial_angle(feet[i].normal, feet[i - 2].normal) * spacing / way);
  }
  return largest;
}

void measure_turn(const Union& all, const BorderLoop& loop, const CollarPlace& place,
                  double spacing, CollarQuality& quality, const Job& job) {
  const std::size_t profiles = (loop.strands.size() + profile_every - 1) / profile_every;
  std::vector<double> turn(profiles);
  parallel_for(job, "", profiles, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      turn[i] =
          largest_turn(all, profile(loop, place, i * profile_every, probe_step * spacing), spacing);
  });
  for (const double t : turn) quality.turn.add(t);
}

void measure_density(const Union& all, std::span<const Vec3> collar, double spacing,
                     CollarQuality& quality) {
  MlsScratch scratch;
  double sum = 0, squares = 0, least = infinity;
  for (const Vec3& p : collar) {
    const double d = all.nearest(p, 1, scratch) / spacing;
    sum += d;
    squares += d * d;
    least = std::min(least, d);
  }
  if (collar.empty()) return;
  const double mean = sum / static_cast<double>(collar.size());
  const double variance = squares / static_cast<double>(collar.size()) - mean * mean;
  quality.nearest_cv = mean > 0 ? std::sqrt(std::max(variance, 0.0)) / mean : 0;
  quality.nearest_min = least;
}

}  // namespace

CollarQuality measure_collar(std::span<const Vec3> points, std::size_t collar_points,
                             const BorderLoop& loop, const CollarPlace& place,
                             const CloudSide& cloud, const Job& job) {
  CollarQuality quality;
  if (points.size() < 9) return quality;
  const double d = cloud.spacing();
  const Union all(points, cloud, job);
  measure_borders(all, loop, quality);
  measure_turn(all, loop, place, d, quality, job);
  quality.ripple = ripple_of(all, loop, place, d, job);
  quality.gap = gap_of(all, loop, place, d, job);
  measure_density(all, points.first(collar_points), d, quality);
  return quality;
}

}  // namespace spigolo
