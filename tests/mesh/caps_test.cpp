// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/mesh/caps_test.cpp - holes closed as what is around them goes on
#include "spigolo/mesh/caps.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "spigolo/mesh/check.h"
#include "support/mesh_shapes.h"

namespace spigolo {
namespace {

constexpr double step = 2 * pi / 40;  // of the balls below, along the equator

TriangleMesh ball_without_top(double height) {
  TriangleMesh mesh = ball(40, 21);
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    return std::any_of(t.begin(), t.end(),
                       [&](std::uint32_t v) { return mesh.vertices.points[v].z > height; });
  });
  return mesh;
}

double farthest_from_ball(const TriangleMesh& mesh) {
  double farthest = 0;
  for (const Triangle& t : mesh.triangles)
    for (const std::uint32_t v : t)
      farthest = std::max(farthest, std::abs(norm(mesh.vertices.points[v]) - 1));
  return farthest;
}

void expect_even(const TriangleMesh& mesh, std::size_t first) {
  for (std::size_t t = first; t < mesh.triangles.size(); ++t)
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_LT(distance(mesh.vertices.points[mesh.triangles[t][i]],
                         mesh.vertices.points[mesh.triangles[t][(i + 1) % 3]]),
                2.5 * step);
}

TEST(Caps, ABallIsContinued) {
  for (const double height : {0.9, 0.7, 0.5}) {
    TriangleMesh mesh = ball_without_top(height);
    ASSERT_EQ(check_mesh(mesh).border_loops, 1U);
    const std::size_t before = mesh.triangles.size();
    const CapReport report = close_smoothly(mesh, {step, infinity});
    EXPECT_EQ(report.smooth, 1U);
    const MeshCheck check = check_mesh(mesh);
    EXPECT_TRUE(check.closed() && check.sound());
    EXPECT_EQ(check.euler, 2);
    EXPECT_LT(farthest_from_ball(mesh), 0.05) << height;
    expect_even(mesh, before);
  }
}

TEST(Caps, OnlyHolesThatAreNotTooWide) {
  TriangleMesh mesh = ball_without_top(0.9);
  const std::size_t before = mesh.triangles.size();
  EXPECT_EQ(close_smoothly(mesh, {step, 0.5}).smooth, 0U);
  EXPECT_EQ(mesh.triangles.size(), before);
}

// A box whose top is missing gets it back flat: its walls do not bend.
// The same hole is many edges wide or few, by how long the edges around it are.
TEST(Caps, AHoleIsMeasuredByTheEdgesAroundIt) {
  TriangleMesh mesh = ball_without_top(0.9);
  EXPECT_EQ(close_smoothly(mesh, {step / 8, 0.5}).smooth, 1U);
  EXPECT_TRUE(check_mesh(mesh).closed());
}

TEST(Caps, ABoxGetsAFlatLid) {
  constexpr std::uint32_t n = 8;
  TriangleMesh mesh;
  const TriangleMesh face = square(n);
  const auto add = [&](const auto& place) {
    const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const Vec3& p : face.vertices.points) mesh.vertices.points.push_back(place(p));
    for (const auto& [a, b, c] : face.triangles)
      mesh.triangles.push_back({a + base, b + base, c + base});
  };
  add([](const Vec3& p) { return Vec3{p.y, p.x, 0}; });
  add([](const Vec3& p) { return Vec3{p.x, 0, p.y}; });
  add([](const Vec3& p) { return Vec3{1 - p.x, 1, p.y}; });
  add([](const Vec3& p) { return Vec3{0, 1 - p.x, p.y}; });
  add([](const Vec3& p) { return Vec3{1, p.x, p.y}; });
  // one vertex a place
  const auto& p = mesh.vertices.points;
  for (Triangle& t : mesh.triangles)
    for (std::uint32_t& v : t)
      for (std::uint32_t w = 0; w < v; ++w)
        if (distance(p[w], p[v]) < 1e-12) v = w;
  ASSERT_EQ(check_mesh(mesh).border_loops, 1U);
  const CapReport report = close_smoothly(mesh, {1.0 / n, infinity});
  EXPECT_EQ(report.taut, 1U);
  const MeshCheck check = check_mesh(mesh);
  EXPECT_TRUE(check.closed() && check.sound());
  EXPECT_NEAR(check.volume, 1, 1e-9);
  EXPECT_NEAR(check.area, 6, 1e-9);
}

// The only border of a flat sheet cannot be closed: any cap would lie on the sheet.
TEST(Caps, ASheetStaysOpen) {
  TriangleMesh mesh = square(8);
  const CapReport report = close_smoothly(mesh, {1.0 / 8, infinity});
  EXPECT_EQ(report.left, 1U);
  EXPECT_EQ(mesh.triangles.size(), 128U);
}

}  // namespace
}  // namespace spigolo
