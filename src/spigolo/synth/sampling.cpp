// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/sampling.cpp - random and blue-noise samples
#include "spigolo/synth/sampling.h"

#include "spigolo/core/parallel.h"
#include "spigolo/synth/point_grid.h"

namespace spigolo {
namespace {

constexpr double blue_distance = 0.75;  // share of sqrt(area / count); random darts can reach .83
constexpr std::size_t darts_per_point = 60;  // before the distance shrinks; .75 needs about 16
constexpr double shrink = 0.95;
constexpr std::size_t stop_check = 4096;  // darts between two looks at the stop token
constexpr std::size_t probes = 4096;      // samples that tell the extent and means over the area
constexpr std::uint64_t probe_seed = 1;   // of their own: asking shifts no other number

/// A sample, drawn as often as the density says.
Vec3 draw(const Sampler& sampler, const Gradient& density, Random& random) {
  Vec3 p = sampler(random);
  if (density.even()) return p;
  while (random.uniform(0, density.largest()) >= density.at(p)) p = sampler(random);
  return p;
}

double mean_density(const Shape& shape, const Gradient& density) {
  if (density.even()) return 1;
  Random random(probe_seed);
  const Sampler sampler(shape);
  double sum = 0;
  for (std::size_t i = 0; i < probes; ++i) sum += density.at(sampler(random));
  return sum / probes;
}

}  // namespace

Sampler::Sampler(const Shape& shape) : shape_(shape) {
  double sum = 0;
  for (const Patch& patch : shape.patches) sums_.push_back(sum += patch.area);
}

std::size_t Sampler::patch(Random& random) const {
  const double x = random.uniform(0, sums_.back());
  const auto at = std::upper_bound(sums_.begin(), sums_.end() - 1, x);
  return static_cast<std::size_t>(at - sums_.begin());
}

Box sampled_box(const Shape& shape) {
  Random random(probe_seed);
  return bounding_box(sample_random(shape, probes, random));
}

std::vector<Vec3> sample_random(const Shape& shape, std::size_t count, Random& random,
                                const Gradient& density) {
  const Sampler sampler(shape);
  std::vector<Vec3> points(count);
  for (Vec3& p : points) p = draw(sampler, density, random);
  return points;
}

std::vector<Vec3> sample_blue(const Shape& shape, std::size_t count, Random& random, const Job& job,
                              const Gradient& density) {
  if (count == 0) return {};
  const Sampler sampler(shape);
  const double mean = mean_density(shape, density);
  double r = blue_distance * std::sqrt(area(shape) * mean / static_cast<double>(count));
  PointGrid grid(2 * r, count);
  for (std::size_t dart = 1; grid.points().size() < count; ++dart) {
    if (dart % stop_check == 0) job.check();
    if (dart % (darts_per_point * count) == 0) r *= shrink;
    const Vec3 p = draw(sampler, density, random);
    if (!grid.any_within(p, r / std::sqrt(density.at(p)))) grid.insert(p);
  }
  return grid.points();
}

std::vector<double> nearest_distances(const std::vector<Vec3>& points, double expected,
                                      const Job& job) {
  PointGrid grid(2 * expected, points.size());
  for (const Vec3& p : points) grid.insert(p);
  std::vector<double> nearest(points.size());
  parallel_for(job, "spacing", points.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) nearest[i] = grid.nearest_other(i);
  });
  return nearest;
}

double median_spacing(const std::vector<Vec3>& points, double expected, const Job& job) {
  if (points.size() < 2) return 0;
  return median(nearest_distances(points, expected, job));
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace spigolo
