// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/sampling.h - samples of a shape off any lattice, and their spacing
#pragma once

#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/synth/gradient.h"
#include "spigolo/synth/shape.h"

namespace spigolo {

/// Draws a patch by its share of the area, then a sample of it.
class Sampler {
 public:
  explicit Sampler(const Shape& shape);
  Vec3 operator()(Random& random) const { return shape_.patches[patch(random)].sample(random); }
  std::size_t patch(Random& random) const;

 private:
  const Shape& shape_;
  std::vector<double> sums_;
};

/// The box of a few thousand samples of the shape: its extent but for a small margin.
Box sampled_box(const Shape& shape);

/// Independent samples, as many per area as `density` says.
std::vector<Vec3> sample_random(const Shape& shape, std::size_t count, Random& random,
                                const Gradient& density = {});

/// Random samples of which no two are nearer than .75 sqrt(area / count), by dart throwing over the
/// whole surface; with a density, that distance over its root. Where that many do not fit (sheets
/// closer than the spacing) the distance shrinks until they do. Throws Cancelled.
std::vector<Vec3> sample_blue(const Shape& shape, std::size_t count, Random& random, const Job& job,
                              const Gradient& density = {});

/// Scan lines: cuts of the shape with parallel planes that lie askew to its axes, `across` apart,
/// and samples on them in random steps of `along` on average, at least .65 of it.
struct ScanLines {
  std::vector<Vec3> points;
  double across = 0, along = 0;
};
/// across = 4 along, so that count samples cover the shape. Throws Cancelled.
ScanLines sample_scan(const Shape& shape, std::size_t count, Random& random, const Job& job);

/// What scanners see that stand `views` directions around the shape at four times its radius: first
/// hits of a square grid of rays each, about `count` in all. Throws Cancelled.
std::vector<Vec3> sample_view(const Shape& shape, std::size_t count, std::size_t views,
                              Random& random, const Job& job);

/// Distance of each point to its nearest other one; expected: about its size. Throws Cancelled.
std::vector<double> nearest_distances(const std::vector<Vec3>& points, double expected,
                                      const Job& job);

/// Their median; 0 for fewer than two points.
double median_spacing(const std::vector<Vec3>& points, double expected, const Job& job);

/// The middle of the values in order; 0 if there are none.
double median(std::vector<double> values);

}  // namespace spigolo
