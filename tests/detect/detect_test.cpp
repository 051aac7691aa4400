// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
#include "spigolo/detect/detect.h"

#include <gtest/gtest.h>

#include "spigolo/core/error.h"
#include "spigolo/measure/classification.h"
#include "spigolo/synth/synth.h"
#include "support/clouds.h"

namespace spigolo {
namespace {

SynthCloud synth(const std::string& shape, double angle = radians(90),
                 Sampling sampling = Sampling::automatic, std::size_t points = 0) {
  SynthOptions options;
  options.shape = shape;
  options.angle = angle;
  options.sampling = sampling;
  options.points = points;
  return make_cloud(options);
}

Classification score(const SynthCloud& s, const Detection& detection) {
  return classify(sharp_flags(detection.features), read_truth(s.cloud, s.spacing, s.lattice),
                  Scoring::thin);
}

std::vector<Vec3> transformed(const std::vector<Vec3>& points, double scale, const Vec3& offset) {
  const double c = std::cos(0.7), s = std::sin(0.7);
  std::vector<Vec3> result;
  for (const Vec3& p : points) {
    const Vec3 q{c * p.x - s * p.z, p.y, s * p.x + c * p.z};  // turned around y,
    const Vec3 r{c * q.x - s * q.y, s * q.x + c * q.y, q.z};  // then around z
    result.push_back(r * scale + offset);
  }
  return result;
}

// Table 1 of the thesis: 575 of 580, 257 of 256, 1398 of 1350.
TEST(Detect, ThesisTable1WithoutAMissOrAnOutlier) {
  const std::vector<std::pair<const char*, std::size_t>> sets = {
      {"cube", 488}, {"planes", 256}, {"hole", 1350}, {"hole17k", 838}};
  for (const auto& [shape, features] : sets) {
    const SynthCloud s = synth(shape);
    const Classification c = score(s, detect(s.cloud.points));
    EXPECT_EQ(c.hits, features) << shape;
    EXPECT_EQ(c.outliers, 0u) << shape;
  }
}

// Section 3.7.1: from 45 degrees on perfect, less precise below, nearly straight edges still found.
TEST(Detect, WedgesOfTheThesis) {
  for (const double angle : {25, 45, 60, 90, 110, 140, 160, 170}) {
    const SynthCloud s = synth("wedge", radians(angle));
    const Detection detection = detect(s.cloud.points);
    const Classification c = score(s, detection);
    EXPECT_EQ(c.missed, 0u) << angle;
    EXPECT_LE(c.outliers, 2u) << angle;
    double sum = 0;
    for (const double a : detection.features.angle) sum += a;
    const double mean = degrees(sum) / static_cast<double>(c.flagged);
    EXPECT_NEAR(mean, 180 - angle, angle >= 45 ? 2 : 15) << angle;
  }
}

TEST(Detect, MovingTurningAndScalingChangeNoVerdict) {
  for (const Sampling sampling : {Sampling::random, Sampling::blue}) {
    const SynthCloud s = synth("box", 0, sampling, 3000);
    const auto reference = detect(s.cloud.points).features.kind;
    for (const double scale : {1e-6, 1.0, 1e6}) {
      const auto points = transformed(s.cloud.points, scale, Vec3{300, -20, 7} * scale);
      EXPECT_EQ(detect(points).features.kind, reference) << scale;
    }
  }
  const SynthCloud cube = synth("cube");  // a lattice: distances in ties, turned they are broken
  const SynthCloud turned = [&] {
    SynthCloud t = cube;
    t.cloud.points = transformed(cube.cloud.points, 3.7, {6e3, 5e3, 100});
    return t;
  }();
  const Classification c = score(turned, detect(turned.cloud.points));
  EXPECT_EQ(c.hits, 488u);
  EXPECT_EQ(c.outliers, 0u);
}

TEST(Detect, OrderAndThreadsChangeNoVerdict) {
  const SynthCloud s = synth("planes");
  const auto reference = detect(s.cloud.points);
  for (const int threads : {1, 2, 3, 8}) {
    Job job;
    job.threads = threads;
    const Detection again = detect(s.cloud.points, {}, job);
    EXPECT_EQ(again.features.kind, reference.features.kind) << threads;
    EXPECT_EQ(again.features.angle, reference.features.angle) << threads;
    EXPECT_EQ(again.features.strength, reference.features.strength) << threads;
  }
  std::vector<std::uint32_t> order(s.cloud.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  order = test::shuffled(order, 61);
  std::vector<Vec3> points;
  for (const std::uint32_t i : order) points.push_back(s.cloud.points[i]);
  const Detection shuffled = detect(points);
  for (std::size_t i = 0; i < order.size(); ++i)
    ASSERT_EQ(shuffled.features.kind[i], reference.features.kind[order[i]]);
}

TEST(Detect, RepeatedPointsShareTheirVerdictAndDisturbNobody) {
  const SynthCloud s = synth("cube");
  const auto reference = detect(s.cloud.points).features.kind;
  std::vector<Vec3> points = s.cloud.points;
  for (std::size_t i = 0; i < s.cloud.size(); i += 3) points.push_back(s.cloud.points[i]);
  const Detection detection = detect(points);
  validate(detection.features);
  EXPECT_EQ(detection.duplicates, points.size() - s.cloud.size());
  EXPECT_EQ(detection.warnings.size(), 1u);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t original = i < s.cloud.size() ? i : 3 * (i - s.cloud.size());
    ASSERT_EQ(detection.features.kind[i], reference[original]);
  }
}

TEST(Detect, PointsThatAreNotFiniteAreReportedAndLabelledSurface) {
  const SynthCloud s = synth("cube");
  std::vector<Vec3> points = s.cloud.points;
  points.insert(points.begin() + 100, {not_a_number, 0, 0});
  points.push_back({0, -infinity, 0});
  const Detection detection = detect(points);
  validate(detection.features);
  ASSERT_EQ(detection.features.size(), points.size());
  EXPECT_EQ(detection.features.kind[100], PointKind::surface);
  EXPECT_EQ(detection.features.kind.back(), PointKind::surface);
  EXPECT_EQ(detection.non_finite, 2u);
  EXPECT_EQ(detection.warnings.size(), 1u);
  EXPECT_EQ(detection.features.counts()[1] + detection.features.counts()[2], 488u);
}

TEST(Detect, RefusesWhatHoldsNoSurface) {
  EXPECT_THROW(detect({}), NoResultError);
  EXPECT_THROW(detect(std::vector<Vec3>{{1, 2, 3}}), NoResultError);
  EXPECT_THROW(detect(std::vector<Vec3>(100, Vec3{1, 2, 3})), NoResultError);
  EXPECT_THROW(detect(std::vector<Vec3>(100, Vec3{not_a_number, 2, 3})), NoResultError);
  std::vector<Vec3> line;
  for (int i = 0; i < 100; ++i) line.push_back(Vec3{1, 2, 3} * (0.1 * i) + Vec3{6e6, 5e6, 0});
  EXPECT_THROW(detect(line), NoResultError);
}

TEST(Detect, TinyCloudsTakeFewerNeighborsAndSaySo) {
  std::vector<Vec3> points = test::random_sphere(19, 62);
  const Detection detection = detect(points);
  EXPECT_EQ(detection.k, 18u);
  EXPECT_EQ(detection.warnings.size(), 1u);
}

TEST(Detect, RefusesOptionsOutOfRange) {
  const std::vector<Vec3> points = test::random_sphere(100, 63);
  const auto refused = [&](const auto& change) {
    DetectOptions options;
    change(options);
    EXPECT_THROW(detect(points, options), UsageError);
  };
  refused([](auto& o) { o.k = 3; });
  refused([](auto& o) { o.k = 65; });
  refused([](auto& o) { o.sigma = -0.1; });
  refused([](auto& o) { o.sigma = 2; });
  refused([](auto& o) { o.sigma = not_a_number; });
  refused([](auto& o) { o.flatness = 1.5; });
  refused([](auto& o) { o.min_cluster = 0.6; });
}

TEST(Detect, CanBeCancelled) {
  const SynthCloud s = synth("hole17k");
  std::stop_source source;
  Job job;
  job.stop = source.get_token();
  job.progress = [&](std::string_view stage, double) {
    if (stage == "detect") source.request_stop();
  };
  EXPECT_THROW(detect(s.cloud.points, {}, job), Cancelled);
}

}  // namespace
}  // namespace spigolo
