// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <vector>

#include "spigolo/core/features.h"
#include "spigolo/core/geometry.h"
#include "spigolo/core/parallel.h"
#include "spigolo/core/point_cloud.h"
#include "spigolo/core/random.h"
#include "spigolo/core/symmetric3.h"
#include "spigolo/core/triangle_mesh.h"

namespace spigolo {
namespace {

TEST(Geometry, AnglesAreAccurateAtBothEnds) {
  const Vec3 x{1, 0, 0};
  EXPECT_NEAR(angle_between(x, {1, 1e-9, 0}), 1e-9, 1e-20);
  EXPECT_DOUBLE_EQ(angle_between(x, {-1, 0, 0}), pi);
  EXPECT_NEAR(axial_angle(x, {-1, 1e-9, 0}), 1e-9, 1e-20);
  EXPECT_DOUBLE_EQ(axial_angle(x, {0, 3, 0}), half_pi);
}

TEST(Geometry, PerpendicularIsUnitAndPerpendicular) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 n = random.on_sphere(), t = any_perpendicular(n);
    EXPECT_NEAR(dot(n, t), 0, 1e-15);
    EXPECT_NEAR(norm(t), 1, 1e-15);
  }
}

TEST(Geometry, BoxIgnoresPointsThatAreNotFinite) {
  const std::vector<Vec3> points = {{1, 2, 3}, {not_a_number, 0, 0}, {-1, infinity, 0}, {0, 5, 1}};
  const Box box = bounding_box(points);
  EXPECT_EQ(box.min, (Vec3{0, 2, 1}));
  EXPECT_EQ(box.max, (Vec3{1, 5, 3}));
  EXPECT_TRUE(bounding_box({}).empty());
}

TEST(Symmetric3, ExtremeAxesAreEigenvectorsOfTheExtremeEigenvalues) {
  Random random(43);
  for (int trial = 0; trial < 500; ++trial) {
    Symmetric3 m;
    for (int i = 0; i < 1 + trial % 6; ++i) m.add(random.in_ball());
    const PrincipalAxis large = largest_axis(m), small = smallest_axis(m);
    const auto times = [&](const Vec3& v) {
      return Vec3{m.xx * v.x + m.xy * v.y + m.xz * v.z, m.xy * v.x + m.yy * v.y + m.yz * v.z,
                  m.xz * v.x + m.yz * v.y + m.zz * v.z};
    };
    EXPECT_LT(norm(times(large.axis) - large.axis * large.value), 1e-6 * large.value) << trial;
    EXPECT_LT(norm(times(small.axis) - small.axis * small.value), 1e-6 * large.value) << trial;
    for (int probe = 0; probe < 20; ++probe) {
      const Vec3 v = random.on_sphere();
      EXPECT_LE(dot(v, times(v)), large.value * (1 + 1e-9));
      EXPECT_GE(dot(v, times(v)), small.value - 1e-9 * large.value);
    }
  }
}

// The generator's published first outputs for this state, so that no platform drifts.
TEST(Random, SameBitsEverywhere) {
  Random a(42), b(42), c(43);
  EXPECT_EQ(a.bits(), 0x15780b2e0c2ec716u);
  EXPECT_EQ(b.bits(), 0x15780b2e0c2ec716u);
  EXPECT_NE(c.bits(), 0x15780b2e0c2ec716u);
}

TEST(Random, MomentsOfTheNormalDistribution) {
  Random random(7);
  const int n = 200000;
  double sum = 0, squares = 0, fourth = 0;
  for (int i = 0; i < n; ++i) {
    const double x = random.normal();
    sum += x, squares += x * x, fourth += x * x * x * x;
  }
  EXPECT_NEAR(sum / n, 0, 0.01);
  EXPECT_NEAR(squares / n, 1, 0.015);
  EXPECT_NEAR(fourth / n, 3, 0.1);
}

TEST(Random, BelowIsUniform) {
  Random random(3);
  std::vector<int> histogram(7);
  for (int i = 0; i < 70000; ++i) ++histogram[random.below(7)];
  for (const int count : histogram) EXPECT_NEAR(count, 10000, 400);
}

TEST(Parallel, CoversEveryIndexOnceWithAnyThreads) {
  for (const int threads : {1, 2, 5}) {
    Job job;
    job.threads = threads;
    std::vector<int> hits(10007);
    parallel_for(job, "", hits.size(), 64, [&](std::size_t begin, std::size_t end) {
      EXPECT_EQ(begin % 64, 0u);
      for (std::size_t i = begin; i < end; ++i) ++hits[i];
    });
    for (const int h : hits) ASSERT_EQ(h, 1);
  }
}

TEST(Parallel, StopsAndPassesExceptionsOn) {
  std::stop_source source;
  Job job;
  job.stop = source.get_token();
  std::atomic<int> calls{0};
  EXPECT_THROW(parallel_for(job, "", 1000, 1,
                            [&](std::size_t, std::size_t) {
                              if (++calls == 10) source.request_stop();
                            }),
               Cancelled);
  EXPECT_LT(calls, 1000);
  EXPECT_THROW(
      parallel_for({}, "", 100, 1, [](std::size_t, std::size_t) { throw NoResultError("no"); }),
      NoResultError);
}

TEST(Parallel, ProgressRisesFromZeroToAtMostOne) {
  Job job;
  job.threads = 2;
  double last = -1;
  int reports = 0;
  job.progress = [&](std::string_view stage, double share) {
    EXPECT_EQ(stage, "stage");
    EXPECT_GT(share, last);
    EXPECT_LE(share, 1.0);
    last = share;
    ++reports;
  };
  parallel_for(job, "stage", 100000, 16, [](std::size_t, std::size_t) {});
  EXPECT_GE(reports, 2);
  EXPECT_LE(reports, 101);
}

TEST(PointCloud, ValidateNamesTheFault) {
  PointCloud cloud;
  cloud.points.resize(3);
  cloud.set("quality", ScalarType::float32, {1, 2, 3});
  EXPECT_NO_THROW(validate(cloud));
  cloud.set("quality", ScalarType::float32, {1, 2});
  EXPECT_EQ(cloud.attributes.size(), 1u);
  EXPECT_THROW(validate(cloud), Error);
  cloud.attributes[0] = {"two words", ScalarType::float32, {1, 2, 3}};
  EXPECT_THROW(validate(cloud), Error);
}

TEST(TriangleMesh, ValidateFindsMissingAndRepeatedVertices) {
  TriangleMesh mesh;
  mesh.vertices.points.resize(3);
  mesh.triangles = {{0, 1, 2}};
  EXPECT_NO_THROW(validate(mesh));
  mesh.triangles = {{0, 1, 3}};
  EXPECT_THROW(validate(mesh), Error);
  mesh.triangles = {{0, 1, 1}};
  EXPECT_THROW(validate(mesh), Error);
}

TEST(Features, ValidateHoldsTheContract) {
  Features features;
  features.assign_surface(4);
  EXPECT_NO_THROW(validate(features));
  EXPECT_EQ(features.counts()[0], 4u);
  features.kind[1] = PointKind::edge;
  EXPECT_THROW(validate(features), Error);  // an edge needs a crease point
  features.crease_point[1] = {0, 0, 0};
  EXPECT_NO_THROW(validate(features));
  features.angle[0] = 1;
  EXPECT_THROW(validate(features), Error);  // a surface point has no angle
}

}  // namespace
}  // namespace spigolo
