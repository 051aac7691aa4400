// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/mesh/trim_test.cpp - holes closed, fans split, edges flipped
#include "spigolo/mesh/trim.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stop_token>

#include "spigolo/core/parity_sets.h"
#include "spigolo/mesh/caps.h"
#include "spigolo/mesh/flips.h"
#include "spigolo/mesh/handles.h"
#include "spigolo/mesh/separate.h"
#include "support/mesh_shapes.h"

namespace spigolo {
namespace {

TEST(Holes, AHoleIsClosedAndAWideOneOnRequest) {
  TriangleMesh mesh = ball(16, 9);
  ASSERT_TRUE(check_mesh(mesh).sound());
  const double volume = check_mesh(mesh).volume;
  std::erase_if(mesh.triangles, [](const Triangle& t) { return t[0] == 1; });  // a cap
  ASSERT_EQ(check_mesh(mesh).border_loops, 1U);
  EXPECT_EQ(fill_holes(mesh.triangles, mesh.vertices.points, 0.5), 0U);
  EXPECT_EQ(fill_holes(mesh.triangles, mesh.vertices.points, 2), 1U);
  const MeshCheck check = check_mesh(mesh);
  EXPECT_TRUE(check.closed());
  EXPECT_TRUE(check.sound());
  EXPECT_LT(check.volume, volume);
  EXPECT_GT(check.volume, 0.9 * volume);
}

TEST(Holes, AFillingThatRunsIntoTheMeshGoes) {
  TriangleMesh mesh = ball(16, 9);
  std::erase_if(mesh.triangles, [](const Triangle& t) { return t[0] == 1; });
  const auto base = static_cast<std::uint32_t>(mesh.vertices.size());  // a spike through the hole
  for (const Vec3& p : {Vec3{0, 0, -2}, Vec3{0.1, 0, 0}, Vec3{-0.1, 0, 0}})
    mesh.vertices.points.push_back(mesh.vertices.points[1].z < 0 ? p : -p);
  mesh.triangles.push_back({base, base + 1, base + 2});
  const std::vector<Triangle> before = mesh.triangles;
  EXPECT_EQ(fill_holes(mesh.triangles, mesh.vertices.points, 1), 0U);
  EXPECT_EQ(mesh.triangles, before);
}

// A cone without its base.
TEST(Holes, ALongLoopStaysAndIsNamed) {
  for (const std::size_t n : {longest_loop + 1, std::size_t{100}}) {
    TriangleMesh cone;
    cone.vertices.points = {{0, 0, 1}};
    for (std::uint32_t i = 0; i < n; ++i) {
      const double angle = 2 * pi * i / static_cast<double>(n);
      cone.vertices.points.push_back({std::cos(angle), std::sin(angle), 0});
      cone.triangles.push_back({0, i + 1, static_cast<std::uint32_t>((i + 1) % n + 1)});
    }
    const bool stays = n > longest_loop;
    TriangleMesh filled = cone;
    EXPECT_EQ(fill_holes(filled.triangles, filled.vertices.points, infinity), stays ? 0U : 1U);
    EXPECT_EQ(check_mesh(filled).border_loops, stays ? 1U : 0U);
    const CapReport report = close_smoothly(cone, {1, infinity});
    EXPECT_EQ(report.left, stays ? 1U : 0U);
    EXPECT_EQ(report.too_long, stays ? 1U : 0U);
    EXPECT_EQ(report.smooth + report.taut, stays ? 0U : 1U);
  }
}

TEST(Holes, FillingCanBeCancelled) {
  const std::vector<Vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  std::stop_source source;
  Job job;
  job.stop = source.get_token();
  EXPECT_EQ(fill_loop(square, job).size(), 2U);
  source.request_stop();
  EXPECT_THROW(fill_loop(square, job), Cancelled);
}

// A ball with two of its triangles joined by a tube.
TEST(Handles, ATunnelThreeEdgesAroundGoes) {
  TriangleMesh mesh = ball(16, 9);
  std::vector<Triangle>& triangles = mesh.triangles;
  const std::vector<Triangle> whole = triangles;
  EXPECT_EQ(cut_handles(triangles, mesh.vertices.size()), 0U);
  EXPECT_EQ(triangles, whole);
  const auto [a, b, c] = triangles[60];
  const auto [x, y, z] = triangles[170];
  triangles.erase(triangles.begin() + 170);
  triangles.erase(triangles.begin() + 60);
  for (const Triangle& t :
       {Triangle{a, b, z}, {a, z, x}, {b, c, y}, {b, y, z}, {c, a, x}, {c, x, y}})
    triangles.push_back(t);
  ASSERT_TRUE(check_mesh(mesh).closed() && check_mesh(mesh).oriented());
  ASSERT_EQ(check_mesh(mesh).euler, 0);
  EXPECT_GE(cut_handles(triangles, mesh.vertices.size()), 1U);
  EXPECT_EQ(check_mesh(mesh).border_loops, 2U);
  EXPECT_EQ(fill_holes(triangles, mesh.vertices.points, 3), 2U);
  const MeshCheck check = check_mesh(mesh);
  EXPECT_TRUE(check.closed() && check.sound());
  EXPECT_EQ(check.euler, 2);
}

TEST(Holes, TwoBallsAtOneVertexComeApart) {
  TriangleMesh mesh = ball(8, 5), other = ball(8, 5);
  const auto shift = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Vec3& p : other.vertices.points) mesh.vertices.points.push_back(p + Vec3{0, 0, 2});
  for (Triangle t : other.triangles) {
    for (std::uint32_t& v : t) v = v == 0 ? 1 : v + shift;
    mesh.triangles.push_back(t);
  }
  ASSERT_EQ(check_mesh(mesh).nonmanifold_vertices, 1U);
  const std::uint32_t beside = mesh.triangles.back()[1];
  std::vector<VertexPair> creases = {{1, mesh.triangles[1][1]}, {mesh.triangles.back()[0], beside}};
  EXPECT_EQ(separate(mesh, creases), 1U);
  const MeshCheck check = check_mesh(mesh, creases);
  EXPECT_TRUE(check.sound());
  EXPECT_EQ(check.components, 2U);
  EXPECT_EQ(check.crease_edges_kept, 2U);
}

// Two boxes that share an edge.
TriangleMesh boxes_at_an_edge() {
  TriangleMesh mesh;
  const auto box = [&](const Vec3& low) {
    const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int i = 0; i < 8; ++i)
      mesh.vertices.points.push_back(low + Vec3{double(i & 1), double(i >> 1 & 1), double(i >> 2)});
    constexpr std::uint32_t quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                           {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& q : quads) {
      mesh.triangles.push_back({base + q[0], base + q[1], base + q[2]});
      mesh.triangles.push_back({base + q[0], base + q[2], base + q[3]});
    }
  };
  box({0, 0, 0});
  box({1, 1, 0});
  // corners 3 and 7 of the first are corners 0 and 4 of the second
  for (Triangle& t : mesh.triangles)
    for (std::uint32_t& v : t) v = v == 8 ? 3 : v == 12 ? 7 : v;
  return mesh;
}

TEST(Separate, BoxesAtAnEdgeBecomeTwo) {
  TriangleMesh mesh = boxes_at_an_edge();
  ASSERT_EQ(check_mesh(mesh).nonmanifold_edges, 1U);
  std::vector<VertexPair> creases = {{3, 7}};
  EXPECT_EQ(separate(mesh, creases), 2U);
  const MeshCheck check = check_mesh(mesh, creases);
  EXPECT_TRUE(check.closed() && check.sound());
  EXPECT_EQ(check.components, 2U);
  EXPECT_EQ(check.crease_edges_kept, 1U);
  EXPECT_NEAR(check.volume, 2, 1e-12);
}

// Turned inside out, the two boxes are holes in a block: the inside around the edge hangs together.
TEST(Separate, TheInsideDecides) {
  TriangleMesh mesh = boxes_at_an_edge();
  for (Triangle& t : mesh.triangles) std::swap(t[0], t[1]);
  std::vector<VertexPair> creases;
  separate(mesh, creases);
  const MeshCheck check = check_mesh(mesh);
  EXPECT_TRUE(check.closed() && check.sound());
  EXPECT_EQ(check.components, 1U);
  EXPECT_NEAR(check.volume, -2, 1e-12);
}

TEST(Flips, ThinDiagonalsGoAndCreasesStay) {
  // a long rhombus cut along its long diagonal
  const std::vector<Vec3> points = {{-5, 0, 0}, {5, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  const std::vector<Triangle> cut = {{0, 1, 2}, {1, 0, 3}};
  std::vector<Triangle> triangles = cut;
  EXPECT_EQ(flip_edges(triangles, points, {}).flipped, 1U);
  EXPECT_NE(find_edges(4, triangles).find(2, 3), nullptr);
  const std::vector<VertexPair> creases = {{1, 0}};
  triangles = cut;
  EXPECT_EQ(flip_edges(triangles, points, creases).flipped, 0U);
  EXPECT_EQ(triangles, cut);
}

TEST(ParitySets, KindsFollowFromEachOther) {
  ParitySets sets(5);
  EXPECT_TRUE(sets.join(0, 1, 1));
  EXPECT_TRUE(sets.join(2, 3, 1));
  EXPECT_TRUE(sets.join(1, 2, 0));
  EXPECT_TRUE(sets.join(0, 3, 0));   // follows
  EXPECT_FALSE(sets.join(0, 3, 1));  // contradicts
  EXPECT_TRUE(sets.join(0, 2, 1));
  EXPECT_EQ(sets.find(4).set, 4U);
}

}  // namespace
}  // namespace spigolo
