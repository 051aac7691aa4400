// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/synth/sampling_test.cpp - samples are uniform, blue ones keep their distance
#include <gtest/gtest.h>

#include "spigolo/synth/point_grid.h"
#include "spigolo/synth/sampling.h"
#include "spigolo/synth/synth.h"

namespace spigolo {
namespace {

constexpr std::size_t bins = 20, samples = 40000;
constexpr double chi_square_limit = 50;  // 19 degrees of freedom: exceeded once in 6000 tries

/// share(p): the share of the patch's area that lies below p in some direction; uniform in [0, 1).
template <class Share>
double chi_square(const Patch& patch, const Share& share) {
  Random random(17);
  std::vector<double> count(bins, 0);
  for (std::size_t i = 0; i < samples; ++i) {
    const double s = std::clamp(share(patch.sample(random)), 0.0, 1.0 - 1e-12);
    ++count[static_cast<std::size_t>(s * bins)];
  }
  double sum = 0;
  constexpr double expected = double(samples) / bins;
  for (const double c : count) sum += (c - expected) * (c - expected) / expected;
  return sum;
}

TEST(Uniform, RoundPatches) {
  const Patch cone = turned_segment({}, {1, 0}, {0, 2});
  EXPECT_LT(chi_square(cone, [](const Vec3& p) { return p.x * p.x + p.y * p.y; }),
            chi_square_limit);
  const Patch zone = turned_arc({}, {{}, 1, -0.5, 1.2});
  const double low = std::sin(-0.5), high = std::sin(1.2);
  EXPECT_LT(chi_square(zone, [&](const Vec3& p) { return (p.z - low) / (high - low); }),
            chi_square_limit);
  const Patch torus = turned_arc({}, {{3, 0}, 1, 0, 2 * pi});
  auto turned = [](const Vec3& p) {
    double a = std::atan2(p.z, std::hypot(p.x, p.y) - 3);
    if (a < 0) a += 2 * pi;
    return (3 * a + std::sin(a)) / (6 * pi);
  };
  EXPECT_LT(chi_square(torus, turned), chi_square_limit);
  auto azimuth = [](const Vec3& p) { return std::atan2(p.y, p.x) / (2 * pi) + 0.5; };
  for (const Patch& patch : {cone, zone, torus})
    EXPECT_LT(chi_square(patch, azimuth), chi_square_limit);
  const Patch octant = octant_patch({}, 1);
  EXPECT_LT(chi_square(octant, [](const Vec3& p) { return p.z; }), chi_square_limit);
}

TEST(Uniform, RuledPatchOfStrongTwist) {
  // x in [0, 1], y in [0, 1], z = 6 x y: the area left of x by Simpson's rule
  auto element = [](double u, double v) { return std::sqrt(1 + 36 * (u * u + v * v)); };
  const Patch patch = ruled_patch({[](double u) {
                                     return Vec3{u, 0, 0};
                                   },
                                   [](double u) {
                                     return Vec3{u, 1, 6 * u};
                                   },
                                   element, element(1, 1), 32});
  constexpr int n = 200;
  std::vector<double> left(n + 1, 0);
  for (int i = 0; i < n; ++i) {
    double strip = 0;
    for (int j = 0; j < n; ++j) strip += element((i + 0.5) / n, (j + 0.5) / n);
    left[std::size_t(i) + 1] = left[std::size_t(i)] + strip / (n * n);
  }
  EXPECT_NEAR(patch.area, left[n], 1e-4);
  auto share = [&](double x) {
    const double at = x * n;
    const auto i = std::min<std::size_t>(static_cast<std::size_t>(at), n - 1);
    return (left[i] + (at - double(i)) * (left[i + 1] - left[i])) / left[n];
  };
  EXPECT_LT(chi_square(patch, [&](const Vec3& p) { return share(p.x); }), chi_square_limit);
  EXPECT_LT(chi_square(patch, [&](const Vec3& p) { return share(p.y); }), chi_square_limit);
}

TEST(Uniform, FlatPatchWithHole) {
  const Patch patch = planar_patch({}, {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, {}, 0},
                                   {{{}, {}, 0.5}, {{{0.6, 0.6}, {0.9, 0.6}, {0.9, 0.9}}, {}, 0}});
  EXPECT_NEAR(patch.area, 4 - pi * 0.25 - 0.045, 1e-12);
  Random random(1);
  std::size_t outer = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    const Vec3 p = patch.sample(random);
    EXPECT_GE(std::hypot(p.x, p.y), 0.5);
    EXPECT_FALSE(p.x > 0.6 && p.x < 0.9 && p.y > 0.6 && p.y < p.x);
    outer += p.x < -0.5;
  }
  const double share = 1 / patch.area, sigma = std::sqrt(share * (1 - share) / samples);
  EXPECT_NEAR(double(outer) / samples, share, 4 * sigma);
}

TEST(Uniform, PatchesGetSamplesByTheirArea) {
  const Shape shape = make_shape({.shape = "boxhole"});
  Random random(23);
  std::vector<double> count(shape.patches.size(), 0);
  for (const Vec3& p : sample_random(shape, samples, random))
    for (std::size_t i = 0; i < count.size(); ++i)
      count[i] += distance(p, shape.patches[i].nearest(p)) < 1e-13;
  double sum = 0;
  for (std::size_t i = 0; i < count.size(); ++i) {
    const double expected = samples * shape.patches[i].area / area(shape);
    sum += (count[i] - expected) * (count[i] - expected) / expected;
  }
  EXPECT_LT(sum, 26);  // 6 degrees of freedom: once in 4500 tries
}

TEST(Blue, KeepsItsDistanceOnEveryWideShape) {
  for (const ShapeInfo& known : synth_shapes()) {
    const std::string name = known.name;
    if (name == "plate" || name == "slot") continue;
    const Shape shape = make_shape({.shape = name, .points = 1200});
    Random random(9);
    const auto points = sample_blue(shape, 1200, random, {});
    const double wanted = 0.75 * std::sqrt(area(shape) / 1200);
    double least = infinity;
    for (std::size_t i = 0; i < points.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        least = std::min(least, squared_distance(points[i], points[j]));
    EXPECT_GE(std::sqrt(least), wanted * (1 - 1e-12)) << name;
    const double h = median_spacing(points, wanted, {});
    EXPECT_LT(h, 1.25 * wanted) << name;
  }
}

TEST(Blue, ThinPlatesStillGetAllTheirPoints) {
  const SynthCloud made =
      make_cloud({.shape = "plate", .sampling = Sampling::blue, .points = 1500, .size = 0.2});
  EXPECT_EQ(made.cloud.size(), 1500u);
}

TEST(Blue, CanBeCancelled) {
  std::stop_source source;
  source.request_stop();
  Job job;
  job.stop = source.get_token();
  const Shape shape = make_shape({.shape = "sphere"});
  Random random(1);
  EXPECT_THROW(sample_blue(shape, 100000, random, job), Cancelled);
}

TEST(PointGrid, AgreesWithBruteForce) {
  Random random(31);
  for (const double cell : {0.05, 0.2, 3.0}) {
    PointGrid grid(cell, 10);
    for (int i = 0; i < 400; ++i) {
      const Vec3 p = random.in_ball();
      const double r = cell * random.uniform();
      bool any = false;
      for (const Vec3& q : grid.points()) any = any || distance(p, q) < r;
      EXPECT_EQ(grid.any_within(p, r), any);
      grid.insert(p);
    }
    for (std::size_t i = 0; i < 400; ++i) {
      double best = infinity;
      for (std::size_t j = 0; j < 400; ++j)
        if (j != i) best = std::min(best, distance(grid.points()[i], grid.points()[j]));
      if (best <= 32 * cell) {
        EXPECT_EQ(grid.nearest_other(i), best);
      }
    }
  }
}

}  // namespace
}  // namespace spigolo
