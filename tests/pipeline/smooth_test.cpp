// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
#include "spigolo/pipeline/smooth.h"

#include <gtest/gtest.h>

#include "spigolo/core/error.h"
#include "spigolo/detect/detect.h"
#include "spigolo/synth/synth.h"
#include "support/clouds.h"

namespace spigolo {
namespace {

constexpr SmoothMethod methods[] = {SmoothMethod::plain, SmoothMethod::feature_line,
                                    SmoothMethod::sheets};

std::vector<Vec3> box(double noise) {
  SynthOptions options;
  options.shape = "box";
  options.points = 4000;
  options.noise = noise;
  return make_cloud(options).cloud.points;
}

SmoothOptions by(SmoothMethod method) {
  SmoothOptions options;
  options.method = method;
  return options;
}

// Once one of three thousand went onto a crease across the hole, from some directions only.
TEST(Smooth, SamplesWithoutNoiseStayWhereTheyAre) {
  const Vec3 x = normalized(Vec3{0.7, -0.2, 0.55}), y = normalized(cross(Vec3{0.1, 0.9, -0.3}, x));
  const Vec3 z = cross(x, y);
  for (const std::uint64_t seed : {91u, 92u, 94u}) {
    SynthOptions options;
    options.shape = "boxhole";
    options.points = 3000;
    options.sampling = Sampling::random;
    options.seed = seed;
    std::vector<Vec3> points = make_cloud(options).cloud.points;
    for (Vec3& p : points) p = {dot(p, x), dot(p, y), dot(p, z)};
    const Smoothed s = smooth(points, by(SmoothMethod::sheets));
    for (std::size_t i = 0; i < points.size(); ++i)
      ASSERT_LT(s.deviation[i], 0.06 * s.spacing) << "point " << i << ", seed " << seed;
  }
}

// Places were chosen along the space-filling curve and curvature was drawn to zero by its own axes,
// so that a turned cloud ended up to .18 spacings beside.
TEST(Smooth, ATurnedCloudEndsWhereItDidBefore) {
  const Vec3 x = normalized(Vec3{0.7, -0.2, 0.55}), y = normalized(cross(Vec3{0.1, 0.9, -0.3}, x));
  const Vec3 z = cross(x, y);
  for (const double noise : {0.0, 0.1}) {
    const std::vector<Vec3> points = box(noise);
    std::vector<Vec3> turned;
    for (const Vec3& p : points) turned.push_back({dot(p, x), dot(p, y), dot(p, z)});
    const Smoothed a = smooth(points), b = smooth(turned);
    std::size_t elsewhere = 0;  // a choice between two as good may still turn
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec3 &p = a.position[i], &q = b.position[i];
      elsewhere += distance(Vec3{dot(p, x), dot(p, y), dot(p, z)}, q) > 1e-6 * a.spacing;
    }
    EXPECT_LE(elsewhere, points.size() / 20) << noise;
  }
}

TEST(Smooth, OneSoundEntryForEveryPoint) {
  for (const double noise : {0.0, 0.3}) {
    const std::vector<Vec3> points = box(noise);
    for (const SmoothMethod method : methods) {
      const Smoothed s = smooth(points, by(method));
      ASSERT_EQ(s.size(), points.size());
      EXPECT_NO_THROW(validate(s));
      for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_TRUE(on_surface(s.status[i]));
        EXPECT_NEAR(s.deviation[i], distance(points[i], s.position[i]), 1e-12);
        EXPECT_LT(s.deviation[i], 3 * s.spacing);
      }
    }
  }
}

TEST(Smooth, ThreadsAndOrderChangeNothing) {
  const std::vector<Vec3> points = box(0.1), other = test::shuffled(points, 9);
  Job one, four;
  one.threads = 1, four.threads = 4;
  for (const SmoothMethod method : methods) {
    const Smoothed a = smooth(points, by(method), one), b = smooth(points, by(method), four);
    EXPECT_EQ(a.position, b.position);
    EXPECT_EQ(a.normal, b.normal);
    EXPECT_EQ(test::shuffled(a.position, 9), smooth(other, by(method)).position);
  }
}

TEST(Smooth, GivenLabelsAreUsed) {
  const std::vector<Vec3> points = box(0);
  const Smoothed found = smooth(points, by(SmoothMethod::feature_line));
  const Detection detection = detect(points);
  SmoothOptions options = by(SmoothMethod::feature_line);
  options.features = &detection.features;
  const Smoothed given = smooth(points, options);
  EXPECT_EQ(given.position, found.position);
  EXPECT_EQ(given.kind, detection.features.kind);
  Features none;
  none.assign_surface(points.size());
  options.features = &none;
  EXPECT_EQ(smooth(points, options).position, smooth(points, by(SmoothMethod::plain)).position);
}

// Edge labels of the noise-free places, as sure as can be.
Features exact_labels(const SynthCloud& synth) {
  Features labels;
  labels.assign_surface(synth.exact.size());
  for (std::size_t i = 0; i < synth.exact.size(); ++i) {
    double nearest = synth.spacing;
    for (const ExactCrease& crease : synth.shape.creases) {
      const double t = crease.curve.nearest(synth.exact[i]);
      const Vec3 at = crease.curve.at(t);
      if (distance(at, synth.exact[i]) >= nearest) continue;
      nearest = distance(at, synth.exact[i]);
      labels.kind[i] = PointKind::edge;
      labels.strength[i] = 1;
      labels.crease_point[i] = at;
      labels.direction[i] = normalized(crease.curve.at(t + 1e-3) - crease.curve.at(t - 1e-3));
    }
  }
  return labels;
}

// [spacings] Mean distance of the points that end on creases to the true ones.
double crease_error(const SynthCloud& synth, const Smoothed& s) {
  double sum = 0, n = 0;
  for (std::size_t i = 0; i < s.size(); ++i)
    if (s.status[i] == SurfaceStatus::crease)
      sum += edge_distance(synth.shape, s.position[i]) / synth.spacing, n += 1;
  EXPECT_GT(n, 0);
  return sum / n;
}

TEST(Smooth, GivenLabelsPinTheCreasesInMuchNoise) {
  SynthOptions shape;
  shape.shape = "cylinder";
  shape.sampling = Sampling::blue;
  shape.points = 4000;
  shape.noise = 0.7;
  const SynthCloud synth = make_cloud(shape);
  const Features exact = exact_labels(synth);
  SmoothOptions options;
  const double found = crease_error(synth, smooth(synth.cloud.points, options));
  options.features = &exact;
  const double pinned = crease_error(synth, smooth(synth.cloud.points, options));
  EXPECT_LT(pinned, 0.5 * found);
  EXPECT_LT(pinned, 0.1);
  EXPECT_LT(found, 0.5);
  // Labels that do not know where their crease runs pin nothing.
  Features kinds = exact;
  kinds.direction.assign(kinds.size(), {});
  options.features = &kinds;
  EXPECT_GT(crease_error(synth, smooth(synth.cloud.points, options)), 2 * pinned);
}

TEST(Smooth, DuplicatesAndStrayCoordinatesAreCarriedAlong) {
  std::vector<Vec3> points = box(0.1);
  const std::size_t n = points.size();
  const Smoothed plain = smooth(points);
  points.push_back(points[5]);
  points.push_back({not_a_number, 0, 0});
  const Smoothed s = smooth(points);
  EXPECT_NO_THROW(validate(s));
  EXPECT_EQ(s.duplicates, 1u);
  EXPECT_EQ(s.non_finite, 1u);
  EXPECT_EQ(s.position[n], s.position[5]);
  EXPECT_EQ(s.position[5], plain.position[5]);
  EXPECT_EQ(s.status[n + 1], SurfaceStatus::degenerate);
  EXPECT_TRUE(std::isnan(s.deviation[n + 1]));
  EXPECT_EQ(s.warnings.size(), 2u);
}

TEST(Smooth, FlatCloudsStayFlat) {
  for (const SmoothMethod method : methods) {
    const Smoothed s = smooth(test::random_square(400, 5), by(method));
    EXPECT_NO_THROW(validate(s));
    for (const Vec3& p : s.position) EXPECT_NEAR(p.z, 0, 1e-9);
  }
}

TEST(Smooth, CloudsWithoutASurfaceAreRefused) {
  const std::vector<Vec3> few(test::square_lattice(2));
  std::vector<Vec3> line;
  for (int i = 0; i < 50; ++i) line.push_back({1.0 * i, 2.0 * i, 0});
  for (const SmoothMethod method : methods) {
    EXPECT_THROW(smooth(few, by(method)), NoResultError);
    EXPECT_THROW(smooth(line, by(method)), NoResultError);
  }
}

TEST(Smooth, BadOptionsAreToldBeforeTheWork) {
  const std::vector<Vec3> points = box(0);
  SmoothOptions options;
  options.mls.smoothing = -2;
  EXPECT_THROW(smooth(points, options), UsageError);
  Features few;
  few.assign_surface(7);
  options = {};
  options.features = &few;
  EXPECT_THROW(smooth(points, options), UsageError);
}

TEST(Smooth, CanBeCancelled) {
  std::stop_source source;
  source.request_stop();
  Job job;
  job.stop = source.get_token();
  EXPECT_THROW(smooth(box(0), {}, job), Cancelled);
}

}  // namespace
}  // namespace spigolo
