// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/mesh/quality_test.cpp - angles and edges in closed form
#include "spigolo/mesh/quality.h"

#include <gtest/gtest.h>

#include "support/mesh_shapes.h"

namespace spigolo {
namespace {

TEST(Quality, HalvesOfSquares) {
  const TriangleQuality q = measure_quality(square(5));
  EXPECT_NEAR(q.angle_mean, pi / 4, 1e-12);
  EXPECT_NEAR(q.angle_least, pi / 4, 1e-12);
  EXPECT_NEAR(q.angle_p5, pi / 4, 1e-12);
  EXPECT_NEAR(q.aspect_mean, 2, 1e-12);
  EXPECT_NEAR(q.edge_mean, (2 + std::sqrt(2)) / 3 / 5, 1e-12);
  EXPECT_EQ(q.slim, 0);
}

TEST(Quality, EvenAndFlatTriangles) {
  TriangleMesh mesh;
  mesh.vertices.points = {{0, 0, 0}, {2, 0, 0}, {1, std::sqrt(3), 0}, {4, 0, 0}};
  mesh.triangles = {{0, 1, 2}};
  const TriangleQuality even = measure_quality(mesh);
  EXPECT_NEAR(even.angle_mean, pi / 3, 1e-12);
  EXPECT_NEAR(even.aspect_mean, 2 / std::sqrt(3), 1e-12);
  EXPECT_NEAR(even.edge_deviation, 0, 1e-7);
  mesh.triangles.push_back({0, 1, 3});  // no height
  const TriangleQuality half = measure_quality(mesh);
  EXPECT_NEAR(half.angle_least, 0, 1e-12);
  EXPECT_NEAR(half.slim, 0.5, 1e-12);
  EXPECT_EQ(measure_quality({}).angle_mean, 0);
}

}  // namespace
}  // namespace spigolo
