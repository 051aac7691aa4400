// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/synth.cpp - sample a shape, note the truth, add the noise
#include "spigolo/synth/synth.h"

#include <utility>

#include "spigolo/core/error.h"
#include "spigolo/core/features.h"
#include "spigolo/core/parallel.h"
#include "spigolo/synth/catalogue.h"
#include "spigolo/synth/sampling.h"

namespace spigolo {
namespace {

constexpr double on_edge = 1e-12;   // share of the shape's radius that is rounding
constexpr double near_edge = 0.75;  // [spacings] off the lattice, nearer is a feature
constexpr std::uint64_t noise_stream = 0x6e6f697365u;  // noise does not shift the samples' numbers

void check(const SynthOptions& options) {
  if (!(options.noise >= 0 && std::isfinite(options.noise)))
    throw UsageError("the noise of a constructed cloud must be a number of spacings >= 0");
  if (!(options.noise_percent >= 0 && std::isfinite(options.noise_percent)))
    throw UsageError("the noise of a constructed cloud must be a percentage >= 0");
  if (!(options.size > 0 && std::isfinite(options.size)))
    throw UsageError("the size of a fillet, chamfer, plate or slot must be > 0 spacings");
}

std::vector<Vec3> sample(const Construction& made, const SynthOptions& options, const Job& job) {
  const std::size_t count = options.points > 0 ? options.points : made.points;
  Random random(options.seed);
  if (options.sampling == Sampling::lattice) return made.lattice();
  if (options.sampling == Sampling::random) return sample_random(made.shape, count, random);
  return sample_blue(made.shape, count, random, job);
}

PointKind kind_of(const Shape& shape, const Vec3& p, double edge, double limit) {
  if (corner_distance(shape, p) <= limit) return PointKind::corner;
  if (tip_distance(shape, p) <= limit) return PointKind::tip;
  if (edge <= limit) return PointKind::edge;
  return border_distance(shape, p) <= limit ? PointKind::border : PointKind::surface;
}

/// truth_feature, truth_edge_distance and truth_kind of the noise-free samples.
void add_truth(SynthCloud& made, const Job& job) {
  const std::size_t n = made.exact.size();
  const double rounding = on_edge * made.shape.radius;
  const double limit = made.lattice ? rounding : near_edge * made.spacing;
  std::vector<double> feature(n), distance(n), kind(n);
  parallel_for(job, "truth", n, 1024, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const double d = edge_distance(made.shape, made.exact[i]);
      const PointKind k = kind_of(made.shape, made.exact[i], d, limit);
      distance[i] = d <= rounding ? 0 : d;
      kind[i] = static_cast<double>(k);
      feature[i] = k != PointKind::surface && k != PointKind::border;
    }
  });
  made.cloud.set("truth_feature", ScalarType::uint8, std::move(feature));
  made.cloud.set("truth_edge_distance", ScalarType::float64, std::move(distance));
  made.cloud.set("truth_kind", ScalarType::uint8, std::move(kind));
}

void add_noise(SynthCloud& made, const SynthOptions& options) {
  Random random(options.seed ^ noise_stream);
  const double sigma = options.noise * made.spacing;
  const double ball = options.noise_percent / 100 * made.shape.radius;
  for (Vec3& p : made.cloud.points) {
    if (sigma > 0) {
      const double x = random.normal(), y = random.normal(), z = random.normal();
      p += sigma * Vec3{x, y, z};
    }
    if (ball > 0) p += ball * random.in_ball();
  }
  for (const std::size_t axis : {0u, 1u, 2u}) {
    std::vector<double> values(made.exact.size());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = made.exact[i][axis];
    const char* names[] = {"truth_x", "truth_y", "truth_z"};
    made.cloud.set(names[axis], ScalarType::float64, std::move(values));
  }
}

}  // namespace

SynthCloud make_cloud(const SynthOptions& options, const Job& job) {
  check(options);
  Construction made = construct(options);
  SynthOptions settled = options;
  if (settled.sampling == Sampling::automatic)
    settled.sampling = made.lattice ? Sampling::lattice : Sampling::blue;
  if (settled.sampling == Sampling::lattice && !made.lattice)
    throw UsageError("shape '" + options.shape + "' has no lattice; sample it random or blue");

  SynthCloud result;
  result.lattice = settled.sampling == Sampling::lattice;
  result.exact = sample(made, settled, job);
  result.shape = std::move(made.shape);
  const double mean = std::sqrt(area(result.shape) / static_cast<double>(result.exact.size()));
  result.spacing = median_spacing(result.exact, mean, job);
  result.cloud.points = result.exact;
  add_truth(result, job);
  if (options.noise > 0 || options.noise_percent > 0) add_noise(result, options);
  return result;
}

Shape make_shape(const SynthOptions& options) {
  check(options);
  return construct(options).shape;
}

}  // namespace spigolo
