// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/mesh/recover_test.cpp - lost crease segments become edges, or nothing changes
#include "spigolo/mesh/recover.h"

#include <gtest/gtest.h>

#include "support/mesh_shapes.h"

namespace spigolo {
namespace {

constexpr std::uint32_t n = 6;  // cells along a side
std::uint32_t at(std::uint32_t i, std::uint32_t j) { return j * (n + 1) + i; }

MeshCheck check_after(TriangleMesh& mesh, const std::vector<VertexPair>& creases) {
  recover_creases(mesh.triangles, mesh.vertices.points, creases);
  return check_mesh(mesh, creases);
}

TEST(Recover, DiagonalsAreFlipped) {
  TriangleMesh mesh = square(n);
  const std::vector<VertexPair> creases = {{at(2, 1), at(1, 2)}, {at(1, 2), at(0, 3)}};
  const RecoverReport report = recover_creases(mesh.triangles, mesh.vertices.points, creases);
  EXPECT_EQ(report.flipped, 2U);
  EXPECT_EQ(report.inserted, 0U);
  const MeshCheck check = check_mesh(mesh, creases);
  EXPECT_TRUE(check.sound());
  EXPECT_EQ(check.crease_edges_kept, 2U);
  EXPECT_EQ(mesh.triangles.size(), 2 * n * n);
}

TEST(Recover, SegmentsOverTwoEdgesAreFound) {
  TriangleMesh mesh = square(n);
  const MeshCheck check = check_after(mesh, {{at(1, 1), at(2, 3)}});
  EXPECT_TRUE(check.sound());
  EXPECT_EQ(check.crease_edges_kept, 1U);
  EXPECT_EQ(check.euler, 1);
}

// The ridge of a roof whose middle vertices lie above the sheet that cuts it off.
TEST(Recover, VerticesOffTheSurfaceComeIntoIt) {
  TriangleMesh mesh = square(n);
  auto& points = mesh.vertices.points;
  const auto first = static_cast<std::uint32_t>(points.size());
  points.push_back({0.5, 0.58, 0.1});
  points.push_back({0.5, 0.75, 0.1});
  const std::vector<VertexPair> creases = {
      {at(3, 2), at(3, 3)}, {at(3, 3), first}, {first, first + 1}, {first + 1, at(3, 5)}};
  const MeshCheck check = check_after(mesh, creases);
  EXPECT_TRUE(check.sound());
  EXPECT_EQ(check.crease_edges_kept, creases.size());
  EXPECT_EQ(check.euler, 1);
  EXPECT_EQ(check.border_loops, 1U);
}

// A vertex behind another sheet stays where it is.
TEST(Recover, NothingIsDoneThatWouldRunIntoTheSurface) {
  TriangleMesh mesh = square(n);
  const TriangleMesh other = square(n);
  auto& points = mesh.vertices.points;
  const auto base = static_cast<std::uint32_t>(points.size());
  for (const Vec3& p : other.vertices.points) points.push_back(p + Vec3{0.01, 0.013, 0.05});
  for (Triangle t : other.triangles) {
    for (std::uint32_t& v : t) v += base;
    mesh.triangles.push_back(t);
  }
  const auto behind = static_cast<std::uint32_t>(points.size());
  points.push_back({0.58, 0.58, 0.3});
  const std::vector<Triangle> before = mesh.triangles;
  const std::vector<VertexPair> creases = {{at(3, 3), behind}};
  const RecoverReport report = recover_creases(mesh.triangles, points, creases);
  EXPECT_EQ(report.inserted + report.flipped, 0U);
  EXPECT_EQ(mesh.triangles, before);
}

}  // namespace
}  // namespace spigolo
