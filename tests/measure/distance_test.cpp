// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/measure/distance_test.cpp - distances against brute force and closed forms
#include "spigolo/measure/distance.h"

#include <gtest/gtest.h>

#include "spigolo/core/error.h"
#include "spigolo/core/random.h"
#include "spigolo/measure/box_tree.h"
#include "spigolo/measure/samples.h"
#include "spigolo/measure/triangle_distance.h"

namespace spigolo {
namespace {

std::vector<Vec3> ball_points(std::size_t n, std::uint64_t seed, double radius = 1) {
  Random random(seed);
  std::vector<Vec3> points(n);
  for (Vec3& p : points) p = radius * random.in_ball();
  return points;
}

/// Triangles of a prism over a counterclockwise polygon that is star-shaped from its corner 0.
TriangleMesh prism_mesh(const std::vector<std::array<double, 2>>& polygon, double height) {
  const auto n = static_cast<std::uint32_t>(polygon.size());
  TriangleMesh mesh;
  for (const double z : {0.0, height})
    for (const auto& c : polygon) mesh.vertices.points.push_back({c[0], c[1], z});
  for (std::uint32_t i = 1; i + 1 < n; ++i) {
    mesh.triangles.push_back({0, i + 1, i});
    mesh.triangles.push_back({n, n + i, n + i + 1});
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    mesh.triangles.push_back({i, j, n + j});
    mesh.triangles.push_back({i, n + j, n + i});
  }
  return mesh;
}

/// The same triangles, none sharing a vertex.
TriangleMesh unshared(const TriangleMesh& mesh) {
  TriangleMesh soup;
  for (const auto& t : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(soup.vertices.points.size());
    for (const std::uint32_t v : t) soup.vertices.points.push_back(mesh.vertices.points[v]);
    soup.triangles.push_back({first, first + 1, first + 2});
  }
  return soup;
}

double box_signed_distance(const Vec3& p, const Vec3& size) {
  const Vec3 q = p - size * 0.5;
  const Vec3 d{std::abs(q.x) - size.x / 2, std::abs(q.y) - size.y / 2, std::abs(q.z) - size.z / 2};
  const Vec3 out{std::max(d.x, 0.0), std::max(d.y, 0.0), std::max(d.z, 0.0)};
  return norm(out) + std::min(std::max({d.x, d.y, d.z}), 0.0);
}

TEST(Stats, AreTheClosedForms) {
  std::vector<double> d;
  for (int i = 1; i <= 100; ++i) d.push_back(i % 2 == 0 ? i : -i);
  d.push_back(not_a_number);
  const DistanceStats s = summarize(d);
  EXPECT_DOUBLE_EQ(s.mean, 50.5);
  EXPECT_DOUBLE_EQ(s.signed_mean, 0.5);
  EXPECT_DOUBLE_EQ(s.rms, std::sqrt(101.0 * 201 / 6));
  EXPECT_EQ(s.p95, 95);
  EXPECT_EQ(s.max, 100);
  EXPECT_EQ(s.count, 100u);
  EXPECT_EQ(s.skipped, 1u);
  EXPECT_DOUBLE_EQ(share_within(d, 25), 0.25);
  EXPECT_EQ(share_within({}, 1), 0);
  EXPECT_EQ(summarize({}).count, 0u);
  EXPECT_EQ(summarize(std::vector<double>{-3}).p95, 3);
}

TEST(ToPoints, AgreesWithBruteForce) {
  auto to = ball_points(700, 1);
  for (int i = 0; i < 50; ++i) to.push_back(to[0]);  // many times the same
  for (int i = 0; i < 50; ++i) to.push_back({0.1 * i, 0, 0});
  const auto from = ball_points(500, 2, 3);
  const auto found = distances_to_points(from, to);
  for (std::size_t i = 0; i < from.size(); ++i) {
    double best = infinity;
    for (const Vec3& q : to) best = std::min(best, distance(from[i], q));
    EXPECT_EQ(found[i], best);
  }
  for (const double d : distances_to_points(to, to)) EXPECT_EQ(d, 0);
}

TEST(ToPoints, SkipsWhatIsNotFinite) {
  const std::vector<Vec3> points = {{1, 0, 0}, {not_a_number, 0, 0}, {infinity, 0, 0}};
  const auto d = distances_to_points(points, points);
  EXPECT_EQ(d[0], 0);
  EXPECT_TRUE(std::isnan(d[1]) && std::isnan(d[2]));
  EXPECT_THROW(distances_to_points(points, std::span(points).subspan(1)), NoResultError);
  EXPECT_THROW(distances_to_points(points, {}), NoResultError);
}

TEST(BoxTree, TiesGoToTheSmallerItem) {
  std::vector<Box> boxes;
  std::vector<Vec3> points;
  for (int i = 0; i < 1000; ++i) {
    const double x = (i * 7) % 10;
    points.push_back({x, 0, 0});
    boxes.push_back({points.back(), points.back()});
  }
  const BoxTree tree(boxes);
  for (int x = 0; x < 10; ++x) {
    const Vec3 p{double(x), 1, 0};
    std::size_t expected = 0;
    while (points[expected].x != x) ++expected;
    const auto near = tree.nearest(
        p, [&](std::size_t slot) { return squared_distance(p, points[tree.items()[slot]]); });
    EXPECT_EQ(tree.items()[near.slot], expected);
    EXPECT_EQ(near.squared_distance, 1);
  }
}

TEST(Triangle, FootIsTheBestOfItsFlatAndItsEdges) {
  Random random(4);
  auto on_segment = [](const Vec3& p, const Vec3& a, const Vec3& b) {
    const double t = std::clamp(dot(p - a, b - a) / squared_distance(a, b), 0.0, 1.0);
    return distance(p, a + t * (b - a));
  };
  std::array<int, 7> seen{};
  for (int i = 0; i < 5000; ++i) {
    const Vec3 a = random.in_ball(), b = random.in_ball(), c = random.in_ball();
    const Vec3 p = 2.0 * random.in_ball(), n = normalized(cross(b - a, c - a));
    double best = std::min({on_segment(p, a, b), on_segment(p, b, c), on_segment(p, c, a)});
    const Vec3 q = p - dot(p - a, n) * n;
    const bool inside = dot(cross(b - a, q - a), n) > 0 && dot(cross(c - b, q - b), n) > 0 &&
                        dot(cross(a - c, q - c), n) > 0;
    if (inside) best = std::min(best, distance(p, q));
    const TriangleFoot foot = nearest_on_triangle(p, a, b, c);
    EXPECT_NEAR(distance(p, foot.point), best, 1e-11);
    EXPECT_EQ(foot.part == TrianglePart::inside, inside);
    ++seen[static_cast<std::size_t>(foot.part)];
    const Vec3 corner[] = {a, b, c};
    const auto part = static_cast<std::size_t>(foot.part);
    if (part >= 4) {
      EXPECT_EQ(foot.point, corner[part - 4]);
    } else if (part >= 1) {
      const Vec3 &s = corner[part - 1], &e = corner[part % 3];
      EXPECT_LT(norm(cross(foot.point - s, e - s)), 1e-11);
    }
  }
  for (const int n : seen) EXPECT_GT(n, 50);
}

TEST(ToMesh, AgreesWithBruteForceOnASoup) {
  TriangleMesh mesh;
  mesh.vertices.points = ball_points(300, 5);
  for (std::uint32_t i = 0; i < 300; i += 3) mesh.triangles.push_back({i, i + 1, i + 2});
  const auto from = ball_points(400, 6, 2);
  const auto found = distances_to_mesh(from, mesh, false);
  for (std::size_t i = 0; i < from.size(); ++i) {
    double best = infinity;
    for (const auto& t : mesh.triangles) {
      const auto& v = mesh.vertices.points;
      const Vec3 q = nearest_on_triangle(from[i], v[t[0]], v[t[1]], v[t[2]]).point;
      best = std::min(best, distance(from[i], q));
    }
    EXPECT_DOUBLE_EQ(found[i], best);
  }
}

TEST(ToMesh, SignedDistanceOfABoxIsTheClosedForm) {
  const Vec3 size{1, 2, 0.5};
  const TriangleMesh box = prism_mesh({{0, 0}, {1, 0}, {1, 2}, {0, 2}}, 0.5);
  const auto from = ball_points(3000, 7, 3);
  for (const TriangleMesh& mesh : {box, unshared(box)}) {
    const auto found = distances_to_mesh(from, mesh, true);
    for (std::size_t i = 0; i < from.size(); ++i)
      EXPECT_NEAR(found[i], box_signed_distance(from[i], size), 1e-12);
  }
}

TEST(ToMesh, SignIsRightAtConcaveEdges) {
  const TriangleMesh mesh =
      prism_mesh({{0.5, 0.5}, {0.5, 1}, {0, 1}, {0, 0}, {1, 0}, {1, 0.5}}, 0.5);
  Random random(8);
  std::vector<Vec3> from;
  for (int i = 0; i < 4000; ++i)
    from.push_back({random.uniform(-1, 2), random.uniform(-1, 2), random.uniform(-1, 1.5)});
  const auto found = distances_to_mesh(from, mesh, true);
  for (std::size_t i = 0; i < from.size(); ++i) {
    const Vec3& p = from[i];
    const bool in_box = p.x > 0 && p.x < 1 && p.y > 0 && p.y < 1 && p.z > 0 && p.z < 0.5;
    EXPECT_EQ(found[i] < 0, in_box && !(p.x > 0.5 && p.y > 0.5));
  }
}

TEST(ToMesh, TrianglesWithoutAreaAreSkipped) {
  TriangleMesh mesh;
  mesh.vertices.points = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {not_a_number, 0, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 1, 4}};
  const std::vector<Vec3> from = {{0.2, 0.2, 3}, {0.2, 0.2, -3}};
  EXPECT_THROW(distances_to_mesh(from, mesh, true), NoResultError);
  mesh.triangles.push_back({0, 1, 3});
  EXPECT_EQ(distances_to_mesh(from, mesh, true), (std::vector<double>{3, -3}));
}

TEST(ToSegments, AgreesWithClosedFormsAndBruteForce) {
  const std::vector<Vec3> vertices = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {not_a_number, 0, 0}};
  const Segments lines = {
      {0, 1}, {1, 2}, {2, 3}, {0, 0}};  // one without an end, one without length
  const std::vector<Vec3> from = {{1, -1, 0}, {-3, -4, 0}, {2.5, 1, 0}, {0, 0, 7}, {not_a_number}};
  const auto found = distances_to_segments(from, vertices, lines);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_DOUBLE_EQ(found[i], (std::array<double, 4>{1, 5, 0.5, 7}[i]));
  EXPECT_TRUE(std::isnan(found[4]));
  EXPECT_THROW(distances_to_segments(from, vertices, {{0, 3}}), NoResultError);
}

TEST(PlacesBetween, CutLongSidesIntoShortPieces) {
  TriangleMesh mesh;
  mesh.vertices.points = {{0, 0, 0}, {4, 0, 0}, {0, 3, 0}};
  mesh.triangles = {{0, 1, 2}};
  EXPECT_DOUBLE_EQ(area_of(mesh), 6);
  EXPECT_TRUE(places_between(mesh, 5).empty());
  const auto places = places_between(mesh, 0.5);  // ten pieces a side
  EXPECT_EQ(places.size(), 66u - 3u);
  for (const Vec3& p : places) EXPECT_LE(p.x / 4 + p.y / 3, 1 + 1e-12);
  const Segments lines = {{0, 1}, {1, 2}};
  EXPECT_DOUBLE_EQ(length_of(mesh.vertices.points, lines), 9);
  EXPECT_EQ(places_between(mesh.vertices.points, lines, 1).size(), 3u + 4u);
}

TEST(Compare, BothWaysOfTwoParallelGrids) {
  std::vector<Vec3> a, b;
  for (int i = 0; i < 20; ++i)
    for (int j = 0; j < 20; ++j) {
      a.push_back({double(i), double(j), 0});
      if (i < 10) b.push_back({double(i), double(j), 0.5});
    }
  const Comparison c = compare(a, b);
  EXPECT_EQ(c.b_to_a.max, 0.5);
  EXPECT_EQ(c.b_to_a.mean, 0.5);
  EXPECT_EQ(c.a_to_b.max, std::hypot(10, 0.5));
  EXPECT_EQ(c.a_to_b.count, 400u);
}

TEST(Compare, CloudAndMesh) {
  const TriangleMesh mesh = prism_mesh({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 1);
  const std::vector<Vec3> above = {{0.5, 0.5, 1.25}, {0.5, 0.5, 0.75}};
  const Comparison c = compare(above, mesh);
  EXPECT_DOUBLE_EQ(c.a_to_b.mean, 0.25);
  EXPECT_DOUBLE_EQ(c.a_to_b.signed_mean, 0);
  EXPECT_DOUBLE_EQ(c.b_to_a.max, std::sqrt(0.5 + 0.75 * 0.75));
  EXPECT_EQ(c.b_to_a.count, 8u);
}

TEST(Threads, GiveTheSameBytes) {
  const auto from = ball_points(1500, 9), to = ball_points(1500, 10);
  TriangleMesh mesh;
  mesh.vertices.points = to;
  for (std::uint32_t i = 0; i + 2 < 1500; ++i) mesh.triangles.push_back({i, i + 1, i + 2});
  Job one, four;
  one.threads = 1, four.threads = 4;
  EXPECT_EQ(distances_to_points(from, to, one), distances_to_points(from, to, four));
  EXPECT_EQ(distances_to_mesh(from, mesh, true, one), distances_to_mesh(from, mesh, true, four));
}

}  // namespace
}  // namespace spigolo
