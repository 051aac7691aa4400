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

/// Draws a patch by its share of the area, then a sample of it.
class Sampler {
 public:
  explicit Sampler(const Shape& shape) : shape_(shape) {
    double sum = 0;
    for (const Patch& patch : shape.patches) sums_.push_back(sum += patch.area);
  }
  Vec3 operator()(Random& random) const {
    const double x = random.uniform(0, sums_.back());
    const auto at = std::upper_bound(sums_.begin(), sums_.end() - 1, x);
    return shape_.patches[static_cast<std::size_t>(at - sums_.begin())].sample(random);
  }

 private:
  const Shape& shape_;
  std::vector<double> sums_;
};

}  // namespace

std::vector<Vec3> sample_random(const Shape& shape, std::size_t count, Random& random) {
  const Sampler sampler(shape);
  std::vector<Vec3> points(count);
  for (Vec3& p : points) p = sampler(random);
  return points;
}

std::vector<Vec3> sample_blue(const Shape& shape, std::size_t count, Random& random,
                              const Job& job) {
  if (count == 0) return {};
  const Sampler sampler(shape);
  double r = blue_distance * std::sqrt(area(shape) / static_cast<double>(count));
  PointGrid grid(2 * r, count);
  for (std::size_t dart = 1; grid.points().size() < count; ++dart) {
    if (dart % stop_check == 0) job.check();
    if (dart % (darts_per_point * count) == 0) r *= shrink;
    const Vec3 p = sampler(random);
    if (!grid.any_within(p, r)) grid.insert(p);
  }
  return grid.points();
}

double median_spacing(const std::vector<Vec3>& points, double expected, const Job& job) {
  if (points.size() < 2) return 0;
  PointGrid grid(2 * expected, points.size());
  for (const Vec3& p : points) grid.insert(p);
  std::vector<double> nearest(points.size());
  parallel_for(job, "spacing", points.size(), 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) nearest[i] = grid.nearest_other(i);
  });
  const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
  std::nth_element(nearest.begin(), middle, nearest.end());
  return *middle;
}

}  // namespace spigolo
