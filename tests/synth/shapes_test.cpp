// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/synth/shapes_test.cpp - every shape of the catalogue is what it says it is
#include <gtest/gtest.h>

#include <string>

#include "spigolo/synth/sampling.h"
#include "spigolo/synth/synth.h"

namespace spigolo {
namespace {

class EveryShape : public testing::TestWithParam<std::string> {
 protected:
  SynthOptions options{.shape = GetParam(), .sampling = Sampling::random, .points = 1500};
  Shape shape = make_shape(options);

  Vec3 anywhere(Random& random) const { return random.in_ball() * (1.5 * shape.radius); }
};

TEST_P(EveryShape, SamplesLieOnTheSurface) {
  for (const Sampling sampling : {Sampling::random, Sampling::blue}) {
    options.sampling = sampling;
    const SynthCloud made = make_cloud(options);
    ASSERT_EQ(made.cloud.size(), options.points);
    for (const Vec3& p : made.exact) EXPECT_LT(surface_distance(shape, p), 1e-12 * shape.radius);
  }
}

TEST_P(EveryShape, FitsIntoItsBall) {
  if (GetParam() == "hole17k") {
    EXPECT_EQ(shape.radius, 8.5);  // the one the thesis states
    return;
  }
  Random random(3);
  Vec3 low{infinity, infinity, infinity}, high = -low;
  for (const Vec3& p : sample_random(shape, 4000, random))
    for (std::size_t a = 0; a < 3; ++a)
      low[a] = std::min(low[a], p[a]), high[a] = std::max(high[a], p[a]);
  for (std::size_t a = 0; a < 3; ++a) EXPECT_LE(high[a] - low[a], 2 * shape.radius);
  EXPECT_GE(norm(high - low), 2 * 0.9 * shape.radius);
}

TEST_P(EveryShape, NearestPointOfAPatchIsNearerThanAllItsSamples) {
  Random random(5);
  for (const Patch& patch : shape.patches) {
    std::vector<Vec3> samples(800);
    for (Vec3& p : samples) p = patch.sample(random);
    for (int i = 0; i < 40; ++i) {
      const Vec3 p = anywhere(random), foot = patch.nearest(p);
      EXPECT_LT(distance(foot, patch.nearest(foot)), 1e-12 * shape.radius);
      double best = infinity;
      for (const Vec3& q : samples) best = std::min(best, distance(p, q));
      EXPECT_LE(distance(p, foot), best + 1e-12 * shape.radius);
    }
  }
}

TEST_P(EveryShape, NearestPointOfACreaseAgreesWithDensePoints) {
  Random random(7);
  constexpr int steps = 4000;
  std::vector<Vec3> dense;
  double gap = 0;  // between consecutive dense points
  for (const ExactCrease& crease : shape.creases)
    for (int i = 0; i <= steps; ++i) {
      dense.push_back(crease.curve.at(static_cast<double>(i) / steps));
      if (i > 0) gap = std::max(gap, distance(dense[dense.size() - 2], dense.back()));
    }
  for (const Vec3& tip : shape.tips) dense.push_back(tip);
  for (int i = 0; i < 50; ++i) {
    const Vec3 p = anywhere(random);
    double best = infinity;
    for (const Vec3& q : dense) best = std::min(best, distance(p, q));
    const double exact = edge_distance(shape, p);
    if (dense.empty()) {
      EXPECT_EQ(exact, infinity);
    } else {
      EXPECT_LE(exact, best + 1e-12 * shape.radius);
      EXPECT_GE(exact, best - gap);
    }
  }
}

TEST_P(EveryShape, CreasesLieOnTwoPatchesBordersOnOne) {
  auto patches_at = [&](const Vec3& p) {
    int n = 0;
    for (const Patch& patch : shape.patches)
      n += distance(p, patch.nearest(p)) < 1e-11 * shape.radius;
    return n;
  };
  for (const double t : {0.03, 0.31, 0.5, 0.77}) {
    for (const ExactCrease& crease : shape.creases) {
      EXPECT_EQ(patches_at(crease.curve.at(t)), 2);
      EXPECT_GT(crease.deviation(t), 0);
      EXPECT_LT(crease.deviation(t), pi);
    }
    for (const Curve& border : shape.borders) EXPECT_EQ(patches_at(border.at(t)), 1);
  }
  for (const Corner& corner : shape.corners) {
    EXPECT_LT(edge_distance(shape, corner.position), 1e-12 * shape.radius);
    EXPECT_GE(patches_at(corner.position), 3);
  }
}

/// Unit normal of a patch near p, from three feet of points about it.
Vec3 normal_near(const Patch& patch, const Vec3& p, double step) {
  const Vec3 a = patch.nearest(p), b = patch.nearest(p + Vec3{step, 0, step / 3});
  const Vec3 c = patch.nearest(p + Vec3{step / 2, step, -step});
  return normalized(cross(b - a, c - a));
}

TEST_P(EveryShape, CreasesHaveTheAngleOfTheirPatches) {
  const double near = 1e-3 * shape.radius;
  Random random(11);
  for (const ExactCrease& crease : shape.creases) {
    const double t = 0.37;
    const Vec3 at = crease.curve.at(t);
    std::vector<Vec3> normals;
    for (const Patch& patch : shape.patches) {
      if (distance(at, patch.nearest(at)) > 1e-11 * shape.radius) continue;
      Vec3 inside = at;  // a point of the patch a little off the crease
      for (int i = 0; i < 200 && distance(inside, at) < near / 2; ++i)
        if (const Vec3 q = patch.nearest(at + near * random.on_sphere());
            distance(q, nearest_point(crease.curve, q)) > near / 2)
          inside = q;
      normals.push_back(normal_near(patch, inside, near / 10));
    }
    ASSERT_EQ(normals.size(), 2u);
    const double expected = crease.deviation(t);
    EXPECT_NEAR(axial_angle(normals[0], normals[1]), std::min(expected, pi - expected), 0.01);
  }
}

std::string test_name(const testing::TestParamInfo<std::string>& set) {
  std::string name = set.param;
  for (char& c : name)
    if (c == '-') c = '_';
  return name;
}

std::vector<std::string> names() {
  std::vector<std::string> list;
  for (const ShapeInfo& known : synth_shapes()) list.emplace_back(known.name);
  return list;
}

INSTANTIATE_TEST_SUITE_P(All, EveryShape, testing::ValuesIn(names()), test_name);

TEST(Shapes, AreasAreTheClosedForms) {
  auto area_of = [](const char* name) { return area(make_shape({.shape = name})); };
  EXPECT_DOUBLE_EQ(area_of("cube"), 6 * 41.0 * 41);
  EXPECT_DOUBLE_EQ(area_of("sphere"), pi);
  EXPECT_DOUBLE_EQ(area_of("torus"), 4 * pi * pi * 0.5 * 0.2);
  EXPECT_DOUBLE_EQ(area_of("cone"), pi * 0.25 + pi * 0.5 * std::hypot(0.5, 1));
  EXPECT_DOUBLE_EQ(area_of("boxhole"), 2 * (0.8 + 0.6 + 0.48) - 2 * pi * 0.04 + 2 * pi * 0.2 * 0.6);
  EXPECT_NEAR(area_of("lens"), 2 * 2 * pi * 0.2, 1e-12);
  EXPECT_NEAR(area_of("cap"), 2 * pi * 0.5 * 0.7 + pi * 0.21, 1e-12);
  EXPECT_NEAR(area_of("pyramid"), 1 + 2 * std::hypot(0.7, 0.5), 1e-12);
}

TEST(Shapes, TrimmedAreasAreTheShareOfKeptSamples) {
  const Shape shape = make_shape({.shape = "cylinders"});
  Random random(2);
  constexpr int n = 400000;
  int thick = 0, thin = 0;
  for (int i = 0; i < n; ++i) {
    const double a = random.uniform(0, 2 * pi), s = random.uniform(-1, 1);
    thick += std::hypot(0.4 * std::sin(a), 0.6 * s) > 0.25;
    thin += std::hypot(0.25 * std::sin(a), 0.8 * s) > 0.4;
  }
  EXPECT_NEAR(shape.patches[0].area, 2 * pi * 0.4 * 1.2 * thick / n, 0.01);
  EXPECT_NEAR(shape.patches[1].area, 2 * pi * 0.25 * 1.6 * thin / n, 0.01);
}

TEST(Shapes, CreasesAreCountedAndSigned) {
  struct Row {
    const char* name;
    std::size_t convex, concave, corners, borders;
  };
  for (const Row row :
       {Row{"cube", 12, 0, 8, 0}, Row{"hole", 14, 0, 8, 0}, Row{"wedge", 1, 0, 0, 6},
        Row{"l-prism", 17, 1, 12, 0}, Row{"steps", 22, 2, 16, 0}, Row{"star", 25, 5, 20, 0},
        Row{"pyramid", 8, 0, 5, 0}, Row{"spike", 1, 0, 0, 0}, Row{"fade", 1, 0, 0, 6},
        Row{"chamfer-box", 48, 0, 24, 0}, Row{"slot", 22, 2, 16, 0}, Row{"cylinders", 4, 2, 0, 0},
        Row{"fillet-box", 0, 0, 0, 0}, Row{"patch", 0, 0, 0, 4}}) {
    const Shape shape = make_shape({.shape = row.name});
    std::size_t convex = 0, concave = 0;
    for (const ExactCrease& crease : shape.creases) (crease.convex > 0 ? convex : concave) += 1;
    EXPECT_EQ(convex, row.convex) << row.name;
    EXPECT_EQ(concave, row.concave) << row.name;
    EXPECT_EQ(shape.corners.size(), row.corners) << row.name;
    EXPECT_EQ(shape.borders.size(), row.borders) << row.name;
  }
}

TEST(Shapes, AnglesAreTheClosedForms) {
  const Shape planes = make_shape({.shape = "planes"});
  for (const double t : {0.0, 0.25, 1.0})
    EXPECT_NEAR(planes.creases[0].deviation(t), radians(180 - (45 + 95 * t)), 1e-12);
  for (const double angle : {25.0, 90.0, 170.0}) {
    const Shape wedge = make_shape({.shape = "wedge", .angle = radians(angle)});
    EXPECT_NEAR(nearest_crease(wedge, {3, 1, 1}).deviation, radians(180 - angle), 1e-12);
    EXPECT_EQ(nearest_crease(wedge, {3, 1, 1}).convex, 1);
  }
  EXPECT_NEAR(make_shape({.shape = "lens"}).creases[0].deviation(0), 2 * std::asin(0.8), 1e-12);
  for (const std::size_t sides : {3u, 4u, 5u, 6u})
    EXPECT_EQ(make_shape({.shape = "pyramid", .sides = sides}).corners.back().valence, int(sides));
}

TEST(Shapes, FadeGoesFromItsAngleToFlat) {
  const Shape fade = make_shape({.shape = "fade", .angle = radians(100)});
  for (const double t : {0.0, 0.5, 0.9, 1.0})
    EXPECT_NEAR(fade.creases[0].deviation(t), radians(80) * (1 - t), 1e-12);
}

TEST(Shapes, SpikeHasTheAngleOfItsTip) {
  for (const double angle : {20.0, 90.0, 150.0}) {
    const Shape spike = make_shape({.shape = "spike", .angle = radians(angle)});
    ASSERT_EQ(spike.tips.size(), 1u);
    const Vec3 rim = spike.creases[0].curve.at(0), other = spike.creases[0].curve.at(0.5);
    EXPECT_NEAR(angle_between(rim - spike.tips[0], other - spike.tips[0]), radians(angle), 1e-12);
    EXPECT_NEAR(spike.creases[0].deviation(0), half_pi + radians(angle / 2), 1e-12);
  }
}

}  // namespace
}  // namespace spigolo
