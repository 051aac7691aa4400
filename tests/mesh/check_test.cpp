// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/mesh/check_test.cpp - meshes that are sound and meshes that are not, in every way counted
#include "spigolo/mesh/check.h"

#include <gtest/gtest.h>

#include "spigolo/core/random.h"
#include "spigolo/mesh/orient.h"
#include "spigolo/mesh/predicates.h"
#include "spigolo/mesh/triangle_contact.h"

namespace spigolo {
namespace {

// A box of two triangles a side.
TriangleMesh box(const Vec3& min, const Vec3& max) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.points.push_back(
        {i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z});
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

void append(TriangleMesh& mesh, const TriangleMesh& more) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Vec3& p : more.vertices.points) mesh.vertices.points.push_back(p);
  for (const auto& [a, b, c] : more.triangles)
    mesh.triangles.push_back({a + first, b + first, c + first});
}

TEST(Check, ABoxIsClosedManifoldOriented) {
  const std::vector<VertexPair> creases = {{0, 1}, {7, 3}, {0, 7}};
  const MeshCheck check = check_mesh(box({0, 0, 0}, {1, 2, 3}), creases);
  EXPECT_TRUE(check.closed());
  EXPECT_TRUE(check.sound());
  EXPECT_EQ(check.euler, 2);
  EXPECT_EQ(check.components, 1U);
  EXPECT_NEAR(check.area, 22, 1e-12);
  EXPECT_NEAR(check.volume, 6, 1e-12);
  EXPECT_EQ(check.crease_edges, 3U);
  EXPECT_EQ(check.crease_edges_kept, 2U);
}

TEST(Check, ATriangleLessIsABorder) {
  TriangleMesh mesh = box({0, 0, 0}, {1, 1, 1});
  mesh.triangles.pop_back();
  const MeshCheck check = check_mesh(mesh);
  EXPECT_FALSE(check.closed());
  EXPECT_TRUE(check.manifold());
  EXPECT_EQ(check.border_edges, 3U);
  EXPECT_EQ(check.border_loops, 1U);
  EXPECT_EQ(check.euler, 1);
}

TEST(Check, ATurnedTriangleIsSeen) {
  TriangleMesh mesh = box({0, 0, 0}, {1, 1, 1});
  std::swap(mesh.triangles[5][0], mesh.triangles[5][1]);
  EXPECT_EQ(check_mesh(mesh).misoriented_edges, 3U);
}

TEST(Check, AFinIsANonmanifoldEdge) {
  TriangleMesh mesh = box({0, 0, 0}, {1, 1, 1});
  mesh.vertices.points.push_back({-1, -1, 0.5});
  mesh.triangles.push_back({0, 4, 8});
  const MeshCheck check = check_mesh(mesh);
  EXPECT_EQ(check.nonmanifold_edges, 1U);
  EXPECT_FALSE(check.manifold());
}

TEST(Check, TwoBoxesAtOneVertexAreANonmanifoldVertex) {
  TriangleMesh mesh = box({0, 0, 0}, {1, 1, 1});
  append(mesh, box({1, 1, 1}, {2, 2, 2}));
  EXPECT_EQ(check_mesh(mesh).self_intersections, 0U);  // touching at equal corners is none
  for (Triangle& t : mesh.triangles)
    for (std::uint32_t& v : t)
      if (v == 8) v = 7;
  const MeshCheck check = check_mesh(mesh);
  EXPECT_EQ(check.nonmanifold_vertices, 1U);
  EXPECT_EQ(check.nonmanifold_edges, 0U);
  EXPECT_EQ(check.components, 1U);
}

TEST(Check, BoxesThatOverlapIntersect) {
  TriangleMesh mesh = box({0, 0, 0}, {1, 1, 1});
  append(mesh, box({0.5, 0.25, 0.125}, {2, 2, 2}));
  EXPECT_GT(check_mesh(mesh).self_intersections, 0U);
  TriangleMesh apart = box({0, 0, 0}, {1, 1, 1});
  append(apart, box({1 + 1e-15, 0, 0}, {2, 1, 1}));
  EXPECT_EQ(check_mesh(apart).self_intersections, 0U);
  TriangleMesh touching = box({0, 0, 0}, {1, 1, 1});
  append(touching, box({1, 0.25, 0.25}, {2, 0.5, 0.5}));
  EXPECT_GT(check_mesh(touching).self_intersections, 0U);
}

TEST(Check, ACollinearTriangleIsDegenerate) {
  TriangleMesh mesh;
  mesh.vertices.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 1, 3}};
  EXPECT_EQ(check_mesh(mesh).degenerate, 1U);
}

TEST(Check, NothingIsNotClosed) {
  EXPECT_FALSE(check_mesh({}).closed());
  EXPECT_FALSE(check_mesh({}).sound());
}

// The box tree finds what brute force finds.
TEST(Check, IntersectionsAreThoseOfBruteForce) {
  Random random(3);
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  for (std::uint32_t t = 0; t < 300; ++t) {
    const Vec3 center{random.uniform(), random.uniform(), random.uniform()};
    for (int i = 0; i < 3; ++i) points.push_back(center + 0.15 * random.in_ball());
    triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  std::vector<std::array<std::uint32_t, 2>> brute;
  const auto corners = [&](std::uint32_t t) {
    return TrianglePoints{points[3 * t], points[3 * t + 1], points[3 * t + 2]};
  };
  for (std::uint32_t a = 0; a < 300; ++a)
    for (std::uint32_t b = a + 1; b < 300; ++b)
      if (run_into_each_other(corners(a), corners(b))) brute.push_back({a, b});
  EXPECT_GT(brute.size(), 20U);
  EXPECT_EQ(find_self_intersections(points, triangles), brute);
}

TEST(Contact, SharedEdgeAndCorner) {
  const TrianglePoints a{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
  EXPECT_FALSE(run_into_each_other(a, {{{0, 0, 0}, {1, 0, 0}, {0, -1, 0}}}));
  EXPECT_FALSE(run_into_each_other(a, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 1e-9}}}));
  EXPECT_TRUE(run_into_each_other(a, {{{0, 0, 0}, {1, 0, 0}, {0.2, 2, 0}}}));  // folded over
  EXPECT_FALSE(run_into_each_other(a, {{{0, 0, 0}, {-1, 0, 0}, {-1, -1, 0}}}));
  EXPECT_TRUE(run_into_each_other(a, {{{0, 0, 0}, {1, 1, -1}, {1, 1, 1}}}));
  EXPECT_TRUE(run_into_each_other(a, {{{0, 0, 0}, {0.4, 0.2, 0}, {0.2, 0.4, 0}}}));
  EXPECT_FALSE(run_into_each_other(a, {{{0, 0, 0}, {0, 0, 1}, {-1, 0, 1}}}));
}

// Points of one plane with coordinates that are not exact stay off it by the last bits.
TEST(Predicates, SignsAreExact) {
  const Vec3 a{0.1, 0.1, 0.1}, b{12.1, 0.1, 0.1}, c{0.1, 7.3, 0.1};
  EXPECT_EQ(orient3d(a, b, c, {3.3, 4.4, 0.1}), 0);
  EXPECT_EQ(orient3d(a, b, c, {3.3, 4.4, std::nextafter(0.1, 1)}),
            -orient3d(a, b, c, {3.3, 4.4, std::nextafter(0.1, 0)}));
  EXPECT_EQ(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), -1);
  const double third = 1.0 / 3;
  // (t, t, t) lies on the line through (0, 0, 0) and (1, 1, 1), hence in every plane through it
  EXPECT_EQ(orient3d({0, 0, 0}, {1, 1, 1}, {5, 0.3, 0.7}, {third, third, third}), 0);
  EXPECT_EQ(orient2d({0, 0, 0}, {1, 1, 0}, {third, third, 0}, 2), 0);
  EXPECT_EQ(orient2d({0, 0, 0}, {1, 1, 0}, {third, std::nextafter(third, 1), 0}, 2), 1);
}

TEST(Predicates, SwappingTurnsTheSign) {
  Random random(11);
  for (int i = 0; i < 2000; ++i) {
    // nearly coplanar: the filters cannot tell
    const Vec3 u = random.on_sphere(), v = random.on_sphere(), o = random.in_ball();
    const auto in_plane = [&] { return o + random.uniform(-1, 1) * u + random.uniform(-1, 1) * v; };
    const Vec3 a = in_plane(), b = in_plane(), c = in_plane(), d = in_plane();
    const int sign = orient3d(a, b, c, d);
    EXPECT_EQ(orient3d(b, a, c, d), -sign);
    EXPECT_EQ(orient3d(d, b, c, a), -sign);
    EXPECT_EQ(orient3d(b, c, a, d), sign);
  }
}

TEST(Orient, ShuffledTrianglesLookOutAgain) {
  TriangleMesh mesh = box({0, 0, 0}, {3, 3, 3});
  append(mesh, box({1, 1, 1}, {2, 2, 2}));              // a cavity
  append(mesh, box({5, 0, 0}, {6, 1, 1}));              // another body
  append(mesh, box({1.2, 1.2, 1.2}, {1.8, 1.8, 1.8}));  // a body in the cavity
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3)
    std::swap(mesh.triangles[t][0], mesh.triangles[t][2]);
  const OrientReport report = orient_mesh(mesh);
  EXPECT_EQ(report.not_orientable, 0U);
  const MeshCheck check = check_mesh(mesh);
  EXPECT_TRUE(check.oriented());
  EXPECT_NEAR(check.volume, 27 - 1 + 1 + 0.216, 1e-9);
}

TEST(Orient, AMoebiusStripCannotBe) {
  TriangleMesh mesh;
  const std::uint32_t n = 24;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double u = 2 * pi * i / n;
    for (const double v : {-0.3, 0.3})
      mesh.vertices.points.push_back({(2 + v * std::cos(u / 2)) * std::cos(u),
                                      (2 + v * std::cos(u / 2)) * std::sin(u),
                                      v * std::sin(u / 2)});
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = 2 * i, b = 2 * i + 1;
    const std::uint32_t c = i + 1 < n ? a + 2 : 1, d = i + 1 < n ? b + 2 : 0;
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({b, d, c});
  }
  EXPECT_GT(orient_mesh(mesh).not_orientable, 0U);
}

}  // namespace
}  // namespace spigolo
