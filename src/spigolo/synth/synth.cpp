// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/synth.cpp - sample a shape, note the truth, spoil the samples
#include "spigolo/synth/synth.h"

#include <utility>

#include "spigolo/core/error.h"
#include "spigolo/index/spacing.h"
#include "spigolo/synth/catalogue.h"
#include "spigolo/synth/sampling.h"
#include "spigolo/synth/spoil.h"
#include "spigolo/synth/truth.h"

namespace spigolo {
namespace {

constexpr double blue_h = 0.8;  // h of blue samples in sqrt(area per sample)

void require(bool right, const char* message) {
  if (!right) throw UsageError(message);
}

bool in(double x, double low, double high) { return x >= low && x <= high; }

void check(const SynthOptions& o) {
  require(o.noise >= 0 && std::isfinite(o.noise),
          "the noise of a constructed cloud must be a number of spacings >= 0");
  require(o.noise_percent >= 0 && std::isfinite(o.noise_percent),
          "the noise of a constructed cloud must be a percentage >= 0");
  require(o.size > 0 && std::isfinite(o.size),
          "the size of a fillet, chamfer, plate or slot must be > 0 spacings");
  require(in(o.density_gradient, 1, 1000), "the density gradient must lie between 1 and 1000");
  require(in(o.noise_gradient, 1, 1000), "the noise gradient must lie between 1 and 1000");
  require(in(o.duplicates, 0, 1), "the share of duplicates must lie between 0 and 1");
  require(in(o.outliers, 0, 1), "the share of outliers must lie between 0 and 1");
  require(o.views >= 1 && o.views <= 64, "there may be 1 to 64 views");
  require(o.density_gradient == 1 || o.sampling == Sampling::random || o.sampling == Sampling::blue,
          "a density gradient needs random or blue samples");
}

/// The spacing of every place by the samples themselves: h of blue samples of that density.
LocalSpacing spacing_of_samples(const std::vector<Vec3>& points, const Job& job) {
  const OrderedCloud ordered = order_cloud(points, job);
  const KdTree tree(ordered);
  const Spacing spacing = estimate_spacing(tree.points(), find_neighborhoods(tree, 12, job), job);
  LocalSpacing result(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    result[i] = blue_h * spacing.of_point[ordered.rank[i]];
  return result;
}

LocalSpacing spacing_by_density(const SynthCloud& made, const Gradient& density, double expected,
                                const Job& job) {
  std::vector<double> h = nearest_distances(made.exact, expected, job);
  for (std::size_t i = 0; i < h.size(); ++i) h[i] *= std::sqrt(density.at(made.exact[i]));
  const double unit = median(h);
  for (std::size_t i = 0; i < h.size(); ++i) h[i] = unit / std::sqrt(density.at(made.exact[i]));
  return h;
}

/// Fills made.exact and made.spacing; the result is empty if the spacing is the same everywhere.
LocalSpacing sample(const Construction& shape, const SynthOptions& options, SynthCloud& made,
                    const Job& job) {
  const std::size_t count = options.points > 0 ? options.points : shape.points;
  Random random(options.seed);
  if (options.sampling == Sampling::scan) {
    const ScanLines lines = sample_scan(made.shape, count, random, job);
    made.exact = lines.points;
    made.spacing = blue_h * std::sqrt(lines.along * lines.across);
    return LocalSpacing(made.exact.size(), made.spacing);
  }
  if (options.sampling == Sampling::view) {
    made.exact = sample_view(made.shape, count, options.views, random, job);
    LocalSpacing local = spacing_of_samples(made.exact, job);
    made.spacing = median(local);
    return local;
  }
  Gradient density;
  if (options.density_gradient > 1)
    density = Gradient(sampled_box(made.shape), 0, options.density_gradient);
  if (options.sampling == Sampling::lattice) made.exact = shape.lattice();
  if (options.sampling == Sampling::random)
    made.exact = sample_random(made.shape, count, random, density);
  if (options.sampling == Sampling::blue)
    made.exact = sample_blue(made.shape, count, random, job, density);
  const double mean = std::sqrt(area(made.shape) / static_cast<double>(made.exact.size()));
  made.spacing = median_spacing(made.exact, mean, job);
  return density.even() ? LocalSpacing{} : spacing_by_density(made, density, mean, job);
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
  result.shape = std::move(made.shape);
  const LocalSpacing local = sample(made, settled, result, job);
  result.cloud.points = result.exact;
  add_truth(result, local, settled.sampling == Sampling::view, job);
  const std::size_t samples = result.exact.size();
  if (options.noise > 0 || options.noise_percent > 0) add_noise(result, options);
  if (options.duplicates > 0) add_duplicates(result, options);
  if (options.outliers > 0) add_outliers(result, options, samples);
  return result;
}

Shape make_shape(const SynthOptions& options) {
  check(options);
  return construct(options).shape;
}

}  // namespace spigolo
