// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
#include "spigolo/mls/sharp.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "spigolo/core/error.h"
#include "spigolo/core/random.h"
#include "spigolo/synth/synth.h"

namespace spigolo {
namespace {

SynthCloud synth(const char* shape, Sampling sampling, double noise = 0) {
  SynthOptions options;
  options.shape = shape;
  options.sampling = sampling;
  options.noise = noise;
  options.points = 8000;
  options.seed = 9;
  return make_cloud(options);
}

double mean_spacing(const SynthCloud& c) {
  return std::sqrt(area(c.shape) / static_cast<double>(c.cloud.size()));
}

// Mean distance [spacings] of places on the true creases to the projected surface.
double gap(const SynthCloud& c, const SharpSurface& surface) {
  SheetProbe probe = surface.probe();
  double sum = 0;
  int n = 0;
  for (const ExactCrease& crease : c.shape.creases)
    for (int t = 0; t < 20; ++t, ++n) {
      const Vec3 e = crease.curve.at((t + 0.5) / 20);
      sum += distance(project_sharp(surface, e, probe).position, e);
    }
  return sum / n / mean_spacing(c);
}

TEST(Sharp, EdgesAndCornersWithoutASampleOnThemAreKept) {
  for (const char* shape : {"box", "l-prism", "cylinder-hole"})
    for (const Sampling sampling : {Sampling::random, Sampling::blue}) {
      const SynthCloud c = synth(shape, sampling);
      const SharpSurface surface(c.cloud.points);
      EXPECT_LT(gap(c, surface), 0.01) << shape;
      SheetProbe probe = surface.probe();
      for (const Corner& corner : c.shape.corners) {
        const SurfacePoint s = project_sharp(surface, corner.position, probe);
        EXPECT_LT(distance(s.position, corner.position), 0.03 * mean_spacing(c)) << shape;
      }
    }
}

// Samples exactly on a rim seemed to lie a thousandth of a spacing beyond it, by a quadric fitted
// beside it, and so the sheet was taken to go on there.
TEST(Sharp, NoSheetGoesOnBeyondSamplesOnItsEdges) {
  SynthOptions options;
  options.shape = "hole17k";
  const SynthCloud c = make_cloud(options);
  const SharpSurface surface(c.cloud.points);
  SheetProbe probe = surface.probe();
  Random random(5);
  double squares = 0, count = 0;
  for (std::size_t i = 0; i < c.cloud.size(); ++i) {
    if (edge_distance(c.shape, c.exact[i]) > 1.5 * c.spacing) continue;
    const Vec3 query = c.exact[i] + random.in_ball() * (0.3 * c.spacing);
    const SurfacePoint s = project_sharp(surface, query, probe);
    const double off = surface_distance(c.shape, s.position) / c.spacing;
    squares += off * off, count += 1;
  }
  EXPECT_LT(std::sqrt(squares / count), 0.004);
}

TEST(Sharp, NoiseIsSmoothedAndEdgesStay) {
  for (const Sampling sampling : {Sampling::random, Sampling::blue}) {
    const SynthCloud c = synth("box", sampling, 0.2);
    const SharpSurface surface(c.cloud.points);
    EXPECT_LT(gap(c, surface), 0.1);
    SheetProbe probe = surface.probe();
    double before = 0, after = 0;
    for (const Vec3& p : c.cloud.points) {
      const SurfacePoint s = project_sharp(surface, p, probe);
      before += std::pow(surface_distance(c.shape, p), 2);
      after += std::pow(surface_distance(c.shape, s.position), 2);
    }
    EXPECT_LT(std::sqrt(after / before), 0.4);
  }
}

// One bent sheet, or two on top of each other, seem to explain a crease of 160 degrees with noise.
TEST(Sharp, ACreaseOfLittleBendIsNotSmoothedOver) {
  SynthOptions options;
  options.shape = "wedge";
  options.angle = radians(160);
  options.sampling = Sampling::blue;
  options.points = 8000;
  options.noise = 0.2;
  options.seed = 9;
  const SynthCloud c = make_cloud(options);
  const double spacing = mean_spacing(c);
  const SharpSurface surface(c.cloud.points);
  SheetProbe probe = surface.probe();
  double squares = 0, count = 0;
  for (const Vec3& x : c.exact) {
    if (edge_distance(c.shape, x) > 3 * spacing || border_distance(c.shape, x) < 3 * spacing)
      continue;
    const double off =
        surface_distance(c.shape, project_sharp(surface, x, probe).position) / spacing;
    squares += off * off, count += 1;
  }
  EXPECT_LT(std::sqrt(squares / count), 0.05);
}

// Thesis §2.3.2: a projection. The second one stays within what the weights' center may move.
TEST(Sharp, ProjectingTwiceIsProjectingOnce) {
  const SynthCloud c = synth("l-prism", Sampling::random);
  const SharpSurface surface(c.cloud.points);
  SheetProbe probe = surface.probe();
  Random random(4);
  for (std::size_t i = 0; i < c.cloud.size(); i += 40) {
    const Vec3 q = c.cloud.points[i] + random.in_ball() * (0.3 * mean_spacing(c));
    const SurfacePoint once = project_sharp(surface, q, probe);
    const SurfacePoint twice = project_sharp(surface, once.position, probe);
    EXPECT_LT(distance(once.position, twice.position), 0.02 * mean_spacing(c));
  }
}

// Also with noise: the sheets of a place are the same for all queries near it.
TEST(Sharp, ProjectingTwiceIsProjectingOnceWithNoise) {
  const SynthCloud c = synth("box", Sampling::blue, 0.35);
  const SharpSurface surface(c.cloud.points);
  SheetProbe probe = surface.probe();
  std::vector<double> moved;
  for (std::size_t i = 0; i < c.cloud.size(); i += 10) {
    const SurfacePoint once = project_sharp(surface, c.cloud.points[i], probe);
    const SurfacePoint twice = project_sharp(surface, once.position, probe);
    moved.push_back(distance(once.position, twice.position) / mean_spacing(c));
  }
  std::sort(moved.begin(), moved.end());
  EXPECT_LT(moved[moved.size() * 99 / 100], 0.02);
}

TEST(Sharp, FarFromEdgesAThirdOfTheNoiseIsLeftAtMost) {
  for (const char* shape : {"sphere", "box"}) {
    const SynthCloud c = synth(shape, Sampling::blue, 0.35);
    const SharpSurface surface(c.cloud.points);
    SheetProbe probe = surface.probe();
    double squares = 0, count = 0;
    for (std::size_t i = 0; i < c.cloud.size(); ++i) {
      if (!c.shape.creases.empty() && edge_distance(c.shape, c.exact[i]) < 6 * mean_spacing(c))
        continue;
      const SurfacePoint s = project_sharp(surface, c.cloud.points[i], probe);
      squares += std::pow(surface_distance(c.shape, s.position), 2), ++count;
    }
    EXPECT_LT(std::sqrt(squares / count), 0.35 * 0.35 * mean_spacing(c)) << shape;
  }
}

// Samples of a plane, and of a paraboloid seen from its axis: its height is quadratic there.
TEST(Sharp, PlanesAndQuadricsAreReproduced) {
  Random random(3);
  std::vector<Vec3> plane, bowl;
  for (int i = 0; i < 3000; ++i) {
    const double u = random.uniform(-27, 27), v = random.uniform(-27, 27);
    plane.push_back(Vec3{1, 2, 3} + Vec3{0.6, 0, 0.8} * u + Vec3{0, 1, 0} * v);
    bowl.push_back({u, v, 0.01 * u * u - 0.004 * u * v + 0.006 * v * v});
  }
  const SharpSurface flat(plane), curved(bowl);
  SheetProbe on_flat = flat.probe(), on_curved = curved.probe();
  const Vec3 n{-0.8, 0, 0.6};
  for (int i = 0; i < 200; ++i) {
    const Vec3 at = plane[static_cast<std::size_t>(i)];
    const SurfacePoint s = project_sharp(flat, at + n * random.uniform(-0.5, 0.5), on_flat);
    EXPECT_NEAR(dot(s.position - Vec3{1, 2, 3}, n), 0, 1e-9);
  }
  for (const double z : {-0.4, 0.0, 0.3}) {
    const Vec3 p = project_sharp(curved, {0, 0, z}, on_curved).position;
    EXPECT_NEAR(p.z, 0.01 * p.x * p.x - 0.004 * p.x * p.y + 0.006 * p.y * p.y, 1e-9);
  }
}

TEST(Sharp, CurvaturesOfASphere) {
  const SynthCloud c = synth("sphere", Sampling::blue);
  const SharpSurface surface(c.cloud.points);
  SheetProbe probe = surface.probe();
  const double radius = c.shape.radius;
  for (std::size_t i = 0; i < c.cloud.size(); i += 50) {
    const SurfacePoint s = project_sharp(surface, c.cloud.points[i], probe);
    EXPECT_NEAR(std::abs(s.curvature[0]), 1 / radius, 0.05 / radius);
    EXPECT_NEAR(std::abs(s.curvature[1]), 1 / radius, 0.05 / radius);
  }
}

TEST(Sharp, CreaseNearAnEdgeTellsPointTangentAngleAndEnd) {
  const SynthCloud c = synth("box", Sampling::blue);
  const SharpSurface surface(c.cloud.points);
  SheetProbe probe = surface.probe();
  const double s = mean_spacing(c);
  for (const ExactCrease& crease : c.shape.creases) {
    const Vec3 a = crease.curve.at(0), b = crease.curve.at(1), middle = (a + b) / 2;
    const auto place = find_crease_near(surface, middle + Vec3{0.2, 0.1, -0.2} * s, probe);
    ASSERT_TRUE(place);
    EXPECT_LT(norm(cross(place->crease.point - a, normalized(b - a))), 1e-3 * s);
    EXPECT_NEAR(std::abs(dot(place->crease.direction, normalized(b - a))), 1, 1e-6);
    EXPECT_NEAR(degrees(place->deviation), 90, 0.1);
    EXPECT_FALSE(place->corner);
    const auto end = find_crease_near(surface, a + (b - a) * (0.8 * s / distance(a, b)), probe);
    ASSERT_TRUE(end && end->corner);
    EXPECT_LT(distance(*end->corner, a), 0.01 * s);
  }
}

TEST(Sharp, QueriesWithoutASurfaceSaySo) {
  const SynthCloud c = synth("box", Sampling::random);
  const SharpSurface surface(c.cloud.points);
  SheetProbe probe = surface.probe();
  const Vec3 far{1e3, 0, 0}, broken{not_a_number, 0, 0};
  EXPECT_EQ(project_sharp(surface, far, probe).status, SurfaceStatus::too_far);
  EXPECT_EQ(project_sharp(surface, far, probe).position, far);
  EXPECT_EQ(project_sharp(surface, broken, probe).status, SurfaceStatus::degenerate);
  EXPECT_FALSE(find_crease_near(surface, broken, probe));
  EXPECT_THROW(SharpSurface(std::vector<Vec3>(5)), NoResultError);
}

}  // namespace
}  // namespace spigolo
