// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/mesh/weld_test.cpp - creases on top of each other, triangles that touch by a hair
#include "spigolo/mesh/weld.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "spigolo/mesh/settle.h"
#include "support/mesh_shapes.h"

namespace spigolo {
namespace {

FeatureCurve straight(const Vec3& a, const Vec3& b) {
  FeatureCurve curve;
  curve.kind = CurveKind::edge;
  curve.points = {a, b};
  return curve;
}

double least_distance(const MeshSamples& samples) {
  double least = infinity;
  for (std::size_t v = 0; v < samples.size(); ++v)
    for (std::size_t w = 0; w < v; ++w)
      least = std::min(least, distance(samples.position[v], samples.position[w]));
  return least;
}

double total_length(const MeshSamples& samples) {
  double length = 0;
  for (const auto& [a, b] : samples.creases)
    length += distance(samples.position[a], samples.position[b]);
  return length;
}

TEST(Weld, ACurveThatRunsAlongAnotherIsPartOfIt) {
  FeatureCurves network;
  network.curves = {straight({0, 0, 0}, {10, 0, 0}), straight({7.1, 0.01, 0}, {16.1, 0.01, 0})};
  const MeshSamples samples = sample_creases(network, 1);
  EXPECT_NEAR(total_length(samples), 16.1, 0.01);
  EXPECT_EQ(samples.creases.size(), samples.size() - 1);  // one line
  EXPECT_GT(least_distance(samples), 0.09);
  EXPECT_EQ(samples.curve.size(), samples.creases.size());
}

TEST(Weld, CurvesApartStayAsTheyAre) {
  FeatureCurves network;
  network.curves = {straight({0, 0, 0}, {10, 0, 0}), straight({0, 0.4, 0}, {10, 0.4, 0}),
                    straight({5, -3, 0}, {5, -0.35, 0})};
  const MeshSamples samples = sample_creases(network, 1);
  EXPECT_EQ(samples.creases.size(), 23U);
  EXPECT_EQ(samples.size(), 26U);
}

// Two of the corners of a ball pushed through its other side: at their old places all is well.
TEST(Settle, WhatTouchesGoesToItsSafePlace) {
  const TriangleMesh safe = ball(16, 9);
  TriangleMesh mesh = safe;
  mesh.vertices.points[0] = -1.2 * safe.vertices.points[0];
  mesh.vertices.points[40] = -1.2 * safe.vertices.points[40];
  ASSERT_GT(check_mesh(mesh).self_intersections, 0U);
  const auto place = [&](std::uint32_t v) { return safe.vertices.points[v]; };
  const std::size_t moved = settle(mesh.triangles, mesh.vertices.points, place);
  EXPECT_GE(moved, 2U);
  EXPECT_TRUE(check_mesh(mesh).sound());
  EXPECT_EQ(settle(mesh.triangles, mesh.vertices.points, place), 0U);
}

}  // namespace
}  // namespace spigolo
