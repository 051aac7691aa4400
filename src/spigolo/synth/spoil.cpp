// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/spoil.cpp - noise, repeated points, outliers
#include "spigolo/synth/spoil.h"

#include <utility>

#include "spigolo/synth/gradient.h"
#include "spigolo/synth/sampling.h"

namespace spigolo {
namespace {

// Streams of their own: no disturbance shifts the numbers of another, nor the samples'.
constexpr std::uint64_t noise_stream = 0x6e6f697365u, duplicate_stream = 0x747769636555u,
                        outlier_stream = 0x6f7574u;
constexpr double around = 1.2;  // outliers: size of their box in that of the shape

std::size_t share_of(double share, std::size_t count) {
  return static_cast<std::size_t>(std::llround(share * static_cast<double>(count)));
}

}  // namespace

void add_noise(SynthCloud& made, const SynthOptions& options) {
  Random random(options.seed ^ noise_stream);
  Gradient gradient;
  if (options.noise_gradient > 1)
    gradient = Gradient(sampled_box(made.shape), 1, options.noise_gradient);
  const double sigma = options.noise * made.spacing;
  const double ball = options.noise_percent / 100 * made.shape.radius;
  for (Vec3& p : made.cloud.points) {
    const double factor = gradient.at(p);
    if (sigma > 0) {
      const double x = random.normal(), y = random.normal(), z = random.normal();
      p += factor * sigma * Vec3{x, y, z};
    }
    if (ball > 0) p += factor * ball * random.in_ball();
  }
  for (const std::size_t axis : {0u, 1u, 2u}) {
    std::vector<double> values(made.exact.size());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = made.exact[i][axis];
    const char* names[] = {"truth_x", "truth_y", "truth_z"};
    made.cloud.set(names[axis], ScalarType::float64, std::move(values));
  }
}

void add_duplicates(SynthCloud& made, const SynthOptions& options) {
  Random random(options.seed ^ duplicate_stream);
  const std::size_t n = made.exact.size();
  for (std::size_t i = 0; i < share_of(options.duplicates, n); ++i) {
    const std::size_t of = random.below(n);
    made.exact.push_back(made.exact[of]);
    made.cloud.points.push_back(made.cloud.points[of]);
    for (Attribute& a : made.cloud.attributes) a.values.push_back(a.values[of]);
  }
}

void add_outliers(SynthCloud& made, const SynthOptions& options, std::size_t samples) {
  Random random(options.seed ^ outlier_stream);
  const Box box = sampled_box(made.shape);
  const Vec3 corner = box.center() - around / 2 * box.size(), size = around * box.size();
  const std::size_t first = made.exact.size(), n = first + share_of(options.outliers, samples);
  std::vector<double> outlier(n, 0);
  for (std::size_t i = first; i < n; ++i) {
    const double x = random.uniform(), y = random.uniform(), z = random.uniform();
    const Vec3 p = corner + Vec3{x * size.x, y * size.y, z * size.z};
    outlier[i] = 1;
    made.exact.push_back(p);
    made.cloud.points.push_back(p);
    for (Attribute& a : made.cloud.attributes) {
      double value = 0;
      if (a.name == "truth_edge_distance") value = edge_distance(made.shape, p);
      if (a.name == "truth_spacing") value = made.spacing;
      for (const std::size_t axis : {0u, 1u, 2u})
        if (a.name == std::string("truth_") + "xyz"[axis]) value = p[axis];
      a.values.push_back(value);
    }
  }
  made.cloud.set("truth_outlier", ScalarType::uint8, std::move(outlier));
}

}  // namespace spigolo
