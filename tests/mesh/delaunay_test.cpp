// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/mesh/delaunay_test.cpp - the empty sphere of every tetrahedron, neighbors, volumes
#include "spigolo/mesh/delaunay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "spigolo/core/random.h"

namespace spigolo {
namespace {

Delaunay triangulate(const std::vector<Vec3>& points, double jitter) {
  const Grid grid = make_grid(bounding_box(points));
  std::vector<GridPoint> placed;
  for (std::size_t i = 0; i < points.size(); ++i)
    placed.push_back(grid.place(points[i], jitter, i));
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  Delaunay delaunay;
  delaunay.insert(placed, order, {});
  return delaunay;
}

void expect_delaunay(const Delaunay& d) {
  double volume = 0;
  for (std::uint32_t t = 0; t < d.tetrahedra().size(); ++t) {
    const Tetrahedron& tet = d.tetrahedra()[t];
    if (!tet.alive()) continue;
    const auto p = [&](std::size_t i) { return d.point(tet.v[i]); };
    ASSERT_EQ(grid_orient(p(0), p(1), p(2), p(3)), 1);
    volume += dot(p(1) - p(0), cross(p(2) - p(0), p(3) - p(0)));
    for (std::size_t i = 0; i < 4; ++i) {
      if (tet.neighbor[i] == no_index) continue;
      const Tetrahedron& n = d.tetrahedra()[tet.neighbor[i]];
      ASSERT_TRUE(n.alive());
      ASSERT_EQ(std::count(n.neighbor.begin(), n.neighbor.end(), t), 1);
    }
    for (std::uint32_t v = Delaunay::helpers; v < d.vertices(); ++v)
      ASSERT_LE(grid_in_sphere(p(0), p(1), p(2), p(3), d.point(v)), 0);
  }
  const double side = 2 * grid_reach;
  EXPECT_NEAR(volume / (2 * side * side * side), 1, 1e-9);  // of the tetrahedron around all
}

TEST(Delaunay, RandomPoints) {
  Random random(1);
  std::vector<Vec3> points(300);
  for (Vec3& p : points) p = random.in_ball();
  expect_delaunay(triangulate(points, 0));
}

TEST(Delaunay, ALatticeHasEveryDegeneracy) {
  std::vector<Vec3> points;
  for (int i = 0; i < 216; ++i)
    points.push_back({double(i % 6), double(i / 6 % 6), double(i / 36)});
  const Delaunay d = triangulate(points, 3);
  expect_delaunay(d);
  for (std::uint32_t v = 0; v < d.vertices(); ++v) EXPECT_TRUE(d.has(v));
}

TEST(Delaunay, APlane) {
  std::vector<Vec3> points;
  for (int i = 0; i < 256; ++i) points.push_back({double(i % 16), double(i / 16), 0});
  expect_delaunay(triangulate(points, 3));
}

// On a tiny grid nearly everything is on one sphere or in one plane.
TEST(Delaunay, SignsOfSmallIntegers) {
  const GridPoint a{0, 0, 0}, b{2, 0, 0}, c{0, 2, 0}, d{0, 0, 2};
  EXPECT_EQ(grid_orient(a, b, c, d), 1);
  EXPECT_EQ(grid_orient(a, b, d, c), -1);
  EXPECT_EQ(grid_orient(a, b, c, {1, 1, 0}), 0);
  EXPECT_EQ(grid_in_sphere(a, b, c, d, {2, 2, 2}), 0);
  EXPECT_EQ(grid_in_sphere(a, b, c, d, {1, 1, 1}), 1);
  EXPECT_EQ(grid_in_sphere(a, b, c, d, {2, 2, 3}), -1);
  const double far = 4000000;
  EXPECT_EQ(grid_in_sphere({far, 0, 0}, {0, far, 0}, {0, 0, -far}, {-far, 0, 0}, {0, -far, 0}), 0);
}

TEST(Delaunay, TowardsFindsTheTetrahedronOfADirection) {
  Random random(5);
  std::vector<Vec3> points(100);
  for (Vec3& p : points) p = random.in_ball();
  const Delaunay d = triangulate(points, 0);
  std::vector<std::uint32_t> scratch;
  for (std::uint32_t v = Delaunay::helpers; v < d.vertices(); ++v) {
    const Vec3 direction = random.on_sphere();
    d.star(v, scratch);
    const Tetrahedron& t = d.tetrahedra()[d.towards(v, direction, scratch)];
    const Vec3 ahead = d.point(v) + 10 * direction;  // ten grid units: still inside
    for (std::size_t i = 0; i < 4; ++i) {
      const auto& f = facet_corners[i];
      const Vec3 a = d.point(t.v[f[0]]), b = d.point(t.v[f[1]]), c = d.point(t.v[f[2]]);
      EXPECT_GE(dot(a - ahead, cross(b - ahead, c - ahead)), -1e3);
    }
    EXPECT_NE(std::find(t.v.begin(), t.v.end(), v), t.v.end());
  }
}

}  // namespace
}  // namespace spigolo
