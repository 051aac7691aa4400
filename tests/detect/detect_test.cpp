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

class DetectBy : public testing::TestWithParam<DetectMethod> {
 protected:
  static Detection run(std::span<const Vec3> points, const Job& job = {}) {
    DetectOptions options;
    options.method = GetParam();
    return detect(points, options, job);
  }
};

INSTANTIATE_TEST_SUITE_P(Methods, DetectBy,
                         testing::Values(DetectMethod::sheets, DetectMethod::gauss_map),
                         [](const auto& method) {
                           return method.param == DetectMethod::sheets ? "sheets" : "gauss_map";
                         });

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
TEST_P(DetectBy, ThesisTable1WithoutAMissOrAnOutlier) {
  const std::vector<std::pair<const char*, std::size_t>> sets = {
      {"cube", 488}, {"planes", 256}, {"hole", 1350}, {"hole17k", 838}};
  for (const auto& [shape, features] : sets) {
    const SynthCloud s = synth(shape);
    const Classification c = score(s, run(s.cloud.points));
    EXPECT_EQ(c.hits, features) << shape;
    EXPECT_EQ(c.outliers, 0u) << shape;
  }
}

// Section 3.7.1: from 45 degrees on perfect, less precise below, nearly straight edges still found.
TEST_P(DetectBy, WedgesOfTheThesis) {
  for (const double angle : {25, 45, 60, 90, 110, 140, 160, 170}) {
    const SynthCloud s = synth("wedge", radians(angle));
    const Detection detection = run(s.cloud.points);
    const Classification c = score(s, detection);
    EXPECT_EQ(c.missed, 0u) << angle;
    EXPECT_LE(c.outliers, 2u) << angle;
    double sum = 0;
    for (const double a : detection.features.angle) sum += a;
    const double mean = degrees(sum) / static_cast<double>(c.flagged);
    EXPECT_NEAR(mean, 180 - angle, angle >= 45 ? 2 : 15) << angle;
  }
}

TEST_P(DetectBy, MovingTurningAndScalingChangeNoVerdict) {
  for (const Sampling sampling : {Sampling::random, Sampling::blue}) {
    const SynthCloud s = synth("box", 0, sampling, 3000);
    const auto reference = run(s.cloud.points).features.kind;
    for (const double scale : {1e-6, 1.0, 1e6}) {
      const auto points = transformed(s.cloud.points, scale, Vec3{300, -20, 7} * scale);
      EXPECT_EQ(run(points).features.kind, reference) << scale;
    }
  }
  const SynthCloud cube = synth("cube");  // a lattice: distances in ties, turned they are broken
  const SynthCloud turned = [&] {
    SynthCloud t = cube;
    t.cloud.points = transformed(cube.cloud.points, 3.7, {6e3, 5e3, 100});
    return t;
  }();
  const Classification c = score(turned, run(turned.cloud.points));
  EXPECT_EQ(c.hits, 488u);
  EXPECT_EQ(c.outliers, 0u);
}

// With noise, too: which folds are looked for where favors no axes and no order.
TEST(Detect, TurningANoisyCloudChangesNoVerdict) {
  for (const std::uint64_t seed : {7, 10, 11}) {
    SynthOptions options{.shape = "l-prism", .sampling = Sampling::blue, .points = 3000};
    options.noise = 0.25, options.seed = seed;
    const std::vector<Vec3> points = make_cloud(options).cloud.points;
    EXPECT_EQ(detect(transformed(points, 1, {})).features.kind, detect(points).features.kind)
        << seed;
  }
}

TEST_P(DetectBy, OrderAndThreadsChangeNoVerdict) {
  const SynthCloud s = synth("planes");
  const auto reference = run(s.cloud.points);
  for (const int threads : {1, 2, 3, 8}) {
    Job job;
    job.threads = threads;
    const Detection again = run(s.cloud.points, job);
    EXPECT_EQ(again.features.kind, reference.features.kind) << threads;
    EXPECT_EQ(again.features.angle, reference.features.angle) << threads;
    EXPECT_EQ(again.features.strength, reference.features.strength) << threads;
  }
  std::vector<std::uint32_t> order(s.cloud.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
  order = test::shuffled(order, 61);
  std::vector<Vec3> points;
  for (const std::uint32_t i : order) points.push_back(s.cloud.points[i]);
  const Detection shuffled = run(points);
  for (std::size_t i = 0; i < order.size(); ++i)
    ASSERT_EQ(shuffled.features.kind[i], reference.features.kind[order[i]]);
}

TEST_P(DetectBy, RepeatedPointsShareTheirVerdictAndDisturbNobody) {
  const SynthCloud s = synth("cube");
  const auto reference = run(s.cloud.points).features.kind;
  std::vector<Vec3> points = s.cloud.points;
  for (std::size_t i = 0; i < s.cloud.size(); i += 3) points.push_back(s.cloud.points[i]);
  const Detection detection = run(points);
  validate(detection.features);
  EXPECT_EQ(detection.duplicates, points.size() - s.cloud.size());
  EXPECT_EQ(detection.warnings.size(), 1u);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t original = i < s.cloud.size() ? i : 3 * (i - s.cloud.size());
    ASSERT_EQ(detection.features.kind[i], reference[original]);
  }
}

TEST_P(DetectBy, PointsThatAreNotFiniteAreReportedAndLabelledSurface) {
  const SynthCloud s = synth("cube");
  std::vector<Vec3> points = s.cloud.points;
  points.insert(points.begin() + 100, {not_a_number, 0, 0});
  points.push_back({0, -infinity, 0});
  const Detection detection = run(points);
  validate(detection.features);
  ASSERT_EQ(detection.features.size(), points.size());
  EXPECT_EQ(detection.features.kind[100], PointKind::surface);
  EXPECT_EQ(detection.features.kind.back(), PointKind::surface);
  EXPECT_EQ(detection.non_finite, 2u);
  EXPECT_EQ(detection.warnings.size(), 1u);
  EXPECT_EQ(detection.features.counts()[1] + detection.features.counts()[2], 488u);
}

TEST_P(DetectBy, RefusesWhatHoldsNoSurface) {
  EXPECT_THROW(run({}), NoResultError);
  EXPECT_THROW(run(std::vector<Vec3>{{1, 2, 3}}), NoResultError);
  EXPECT_THROW(run(std::vector<Vec3>(100, Vec3{1, 2, 3})), NoResultError);
  EXPECT_THROW(run(std::vector<Vec3>(100, Vec3{not_a_number, 2, 3})), NoResultError);
  std::vector<Vec3> line;
  for (int i = 0; i < 100; ++i) line.push_back(Vec3{1, 2, 3} * (0.1 * i) + Vec3{6e6, 5e6, 0});
  EXPECT_THROW(run(line), NoResultError);
}

// Samples that do not lie on the edges, on shapes that were not looked at when constants were set.
TEST(Detect, SheetsFindEdgesOffTheLattice) {
  for (const char* shape : {"lens", "pyramid", "steps", "cylinder-hole"})
    for (const Sampling sampling : {Sampling::random, Sampling::blue}) {
      const SynthCloud s = synth(shape, 0, sampling, 6000);
      const Detection detection = detect(s.cloud.points);
      const Classification c =
          classify(sharp_flags(detection.features), read_truth(s.cloud, s.spacing, s.lattice),
                   Scoring::tolerant);
      EXPECT_GT(c.recall, 0.9) << shape;
      EXPECT_GT(c.precision, 0.97) << shape;
    }
}

TEST(Detect, SheetsLeaveSmoothShapesAlone) {
  for (const char* shape : {"sphere", "torus", "patch"})
    for (const Sampling sampling : {Sampling::random, Sampling::blue}) {
      const Detection d = detect(synth(shape, 0, sampling, 8000).cloud.points);
      EXPECT_LE(d.features.counts()[1] + d.features.counts()[2], 8u) << shape;
    }
}

// Noise of a quarter of the spacing: edges are still found, smooth shapes still left alone.
TEST(Detect, SheetsHoldUnderNoise) {
  for (const char* shape : {"boxhole", "steps", "sphere", "torus"})
    for (const Sampling sampling : {Sampling::random, Sampling::blue}) {
      SynthOptions options;
      options.shape = shape;
      options.sampling = sampling;
      options.points = 8000;
      options.noise = 0.25;
      options.seed = 3;
      const SynthCloud s = make_cloud(options);
      const Classification c =
          classify(sharp_flags(detect(s.cloud.points).features),
                   read_truth(s.cloud, s.spacing, s.lattice), Scoring::tolerant);
      if (c.features > 0) {
        EXPECT_GT(c.f1, 0.9) << shape;
      } else {
        EXPECT_LE(c.outliers, 8u) << shape;
      }
    }
}

// Where the creases of a box are is known exactly: all but a few in a hundred, which have a point
// of another face in their sheet, are met to a millionth of the spacing.
TEST(Detect, CreasePointsOfFlatSheetsAreExact) {
  const SynthCloud s = synth("box", 0, Sampling::random, 6000);
  const Detection d = detect(s.cloud.points);
  std::size_t edges = 0, exact = 0;
  for (std::size_t i = 0; i < d.features.size(); ++i) {
    if (d.features.kind[i] != PointKind::edge) continue;
    const double off = edge_distance(s.shape, d.features.crease_point[i]) / d.spacing;
    ++edges;
    exact += off < 1e-6 && std::abs(degrees(d.features.angle[i]) - 90) < 1e-4;
  }
  EXPECT_GT(edges, 200u);
  EXPECT_GT(static_cast<double>(exact), 0.9 * static_cast<double>(edges));
}

TEST(Detect, TinyCloudsTakeFewerNeighborsAndSaySo) {
  std::vector<Vec3> points = test::random_sphere(19, 62);
  DetectOptions options;
  options.method = DetectMethod::gauss_map;
  const Detection detection = detect(points, options);
  EXPECT_EQ(detection.k, 18u);
  EXPECT_EQ(detection.warnings.size(), 1u);
  EXPECT_EQ(detect(points).k, 18u);
  EXPECT_EQ(detect(points).warnings.size(), 1u);
}

TEST(Detect, RefusesOptionsOutOfRange) {
  const std::vector<Vec3> points = test::random_sphere(100, 63);
  const auto refused = [&](const auto& change) {
    DetectOptions options;
    change(options);
    EXPECT_THROW(detect(points, options), UsageError);
  };
  refused([](auto& o) { o.sensitivity = -0.1; });
  refused([](auto& o) { o.sensitivity = 1.1; });
  refused([](auto& o) { o.k = 3; });
  refused([](auto& o) { o.k = 65; });
  refused([](auto& o) { o.sigma = -0.1; });
  refused([](auto& o) { o.sigma = 2; });
  refused([](auto& o) { o.sigma = not_a_number; });
  refused([](auto& o) { o.flatness = 1.5; });
  refused([](auto& o) { o.min_cluster = 0.6; });
}

TEST_P(DetectBy, CanBeCancelled) {
  const SynthCloud s = synth("hole17k");
  std::stop_source source;
  Job job;
  job.stop = source.get_token();
  job.progress = [&](std::string_view stage, double) {
    if (stage == "detect") source.request_stop();
  };
  EXPECT_THROW(run(s.cloud.points, job), Cancelled);
}

}  // namespace
}  // namespace spigolo
