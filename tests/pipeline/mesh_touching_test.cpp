// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/pipeline/mesh_touching_test.cpp - clouds that no single manifold holds: all of them sound
// and said
#include <gtest/gtest.h>

#include <functional>

#include "spigolo/core/error.h"
#include "spigolo/core/random.h"
#include "spigolo/measure/distance.h"
#include "spigolo/pipeline/mesh.h"

namespace spigolo {
namespace {

using Face = std::function<Vec3(double u, double v)>;

// n x m samples of a face, each somewhere in its cell.
void sample_face(std::size_t n, std::size_t m, const Face& face, Random& random,
                 std::vector<Vec3>& out) {
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < m; ++j)
      out.push_back(face(
          (static_cast<double>(i) + 0.5 + random.uniform(-0.3, 0.3)) / static_cast<double>(n),
          (static_cast<double>(j) + 0.5 + random.uniform(-0.3, 0.3)) / static_cast<double>(m)));
}

std::vector<Vec3> box(const Vec3& low, std::size_t n, Random& random) {
  std::vector<Vec3> out;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const double side : {0.0, 1.0})
      sample_face(
          n, n,
          [&](double u, double v) {
            Vec3 p = low;
            p[axis] += side, p[(axis + 1) % 3] += u, p[(axis + 2) % 3] += v;
            return p;
          },
          random, out);
  return out;
}

std::vector<Vec3> ball(const Vec3& center, double r, std::size_t n) {
  std::vector<Vec3> out;
  for (std::size_t i = 0; i < n; ++i) {
    const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(n);
    const double a = 2.399963229728653 * static_cast<double>(i), s = std::sqrt(1 - z * z);
    out.push_back(center + r * Vec3{s * std::cos(a), s * std::sin(a), z});
  }
  return out;
}

void append(std::vector<Vec3>& all, const std::vector<Vec3>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

// Sound by a check of its own, and nothing of the cloud left out.
MeshedCloud expect_sound(const std::vector<Vec3>& cloud) {
  MeshedCloud meshed = mesh_cloud(cloud);
  EXPECT_TRUE(check_mesh(meshed.sharp.mesh, meshed.sharp.creases).sound());
  EXPECT_EQ(meshed.sharp.uncovered, 0U);
  const auto far = distances_to_mesh(cloud, meshed.sharp.mesh, false);
  EXPECT_LT(*std::max_element(far.begin(), far.end()), 1.6 * meshed.spacing);
  return meshed;
}

bool warned(const MeshedCloud& meshed, const char* text) {
  return std::any_of(meshed.warnings.begin(), meshed.warnings.end(),
                     [&](const std::string& w) { return w.find(text) != std::string::npos; });
}

TEST(Touching, AWallOnAFloorIsMeshedApart) {
  Random random(5);
  std::vector<Vec3> cloud;
  sample_face(
      50, 50,
      [](double u, double v) {
        return Vec3{u, v, 0};
      },
      random, cloud);
  sample_face(
      50, 25,
      [](double u, double v) {
        return Vec3{0.5, u, v / 2};
      },
      random, cloud);
  const MeshedCloud meshed = expect_sound(cloud);
  EXPECT_EQ(meshed.sharp.parts, 2U);
  EXPECT_EQ(meshed.sharp.check.components, 2U);
  EXPECT_EQ(meshed.sharp.check.border_loops, 2U);
  EXPECT_TRUE(warned(meshed, "not manifold"));
}

TEST(Touching, AWallInABox) {
  Random random(5);
  std::vector<Vec3> cloud = box({0, 0, 0}, 30, random);
  sample_face(
      30, 30,
      [](double u, double v) {
        return Vec3{0.5, u, v};
      },
      random, cloud);
  const MeshedCloud meshed = expect_sound(cloud);
  EXPECT_EQ(meshed.sharp.parts, 2U);
  EXPECT_NEAR(meshed.sharp.check.area, 7, 0.25);
}

TEST(Touching, TwoBalls) {
  std::vector<Vec3> cloud = ball({0, 0, 0}, 1, 2500);
  append(cloud, ball({2, 0, 0}, 1, 2500));
  const MeshedCloud meshed = expect_sound(cloud);
  EXPECT_NEAR(meshed.sharp.check.area, 8 * pi, 0.1);
}

TEST(Touching, TwoBoxesAtAFaceAndAtAnEdge) {
  for (const Vec3& shift : {Vec3{1, 0, 0}, Vec3{1, 1, 0}}) {
    Random random(5);
    std::vector<Vec3> cloud = box({0, 0, 0}, 30, random);
    append(cloud, box(shift, 30, random));
    expect_sound(cloud);
  }
}

TEST(Touching, ASecondScanATenthOfASpacingOff) {
  Random random(5);
  std::vector<Vec3> cloud = box({0, 0, 0}, 30, random);
  std::vector<Vec3> second = box({0.1 / 30, 0.05 / 30, -0.05 / 30}, 30, random);
  append(cloud, second);
  const MeshedCloud meshed = expect_sound(cloud);
  EXPECT_TRUE(meshed.sharp.check.closed());
  EXPECT_EQ(meshed.sharp.check.euler, 2);
}

TEST(Touching, FlyingPointsAreCountedAndTheRestIsMeshed) {
  Random random(5);
  const std::vector<Vec3> solid = box({0, 0, 0}, 30, random);
  std::vector<Vec3> cloud = solid;
  for (int i = 0; i < 54; ++i)  // one in a hundred
    cloud.push_back({random.uniform(-0.5, 1.5), random.uniform(-0.5, 1.5), random.uniform(1.1, 2)});
  const MeshedCloud meshed = mesh_cloud(cloud);
  EXPECT_TRUE(check_mesh(meshed.sharp.mesh).sound());
  EXPECT_GE(meshed.outliers + meshed.sharp.uncovered, 30U);
  EXPECT_TRUE(warned(meshed, "leaves out"));
  const auto far = distances_to_mesh(solid, meshed.sharp.mesh, false);
  EXPECT_LT(*std::max_element(far.begin(), far.end()), 1.6 * meshed.spacing);
}

TEST(Touching, APlaneIsOneSheet) {
  Random random(5);
  std::vector<Vec3> cloud;
  for (int i = 0; i < 2000; ++i) cloud.push_back({random.uniform(), random.uniform(), 0});
  const MeshedCloud meshed = expect_sound(cloud);
  EXPECT_EQ(meshed.sharp.check.border_loops, 1U);
  EXPECT_EQ(meshed.sharp.check.euler, 1);
}

TEST(Touching, NoiseIsRefused) {
  Random random(5);
  std::vector<Vec3> cloud;
  for (int i = 0; i < 2000; ++i)
    cloud.push_back({random.normal(), random.normal(), random.normal()});
  EXPECT_THROW(mesh_cloud(cloud), NoResultError);
}

}  // namespace
}  // namespace spigolo
