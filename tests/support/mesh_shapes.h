// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/support/mesh_shapes.h - small triangle meshes
#pragma once

#include <cmath>
#include <cstdint>

#include "spigolo/core/triangle_mesh.h"

namespace spigolo {

/// The unit ball by longitudes and latitudes.
inline TriangleMesh ball(std::uint32_t around, std::uint32_t up) {
  TriangleMesh mesh;
  auto& p = mesh.vertices.points;
  p = {{0, 0, -1}, {0, 0, 1}};
  for (std::uint32_t j = 1; j < up; ++j)
    for (std::uint32_t i = 0; i < around; ++i) {
      const double a = 2 * pi * i / around, b = pi * j / up - half_pi;
      p.push_back({std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)});
    }
  const auto at = [&](std::uint32_t i, std::uint32_t j) {
    return 2 + (j - 1) * around + i % around;
  };
  for (std::uint32_t i = 0; i < around; ++i) {
    mesh.triangles.push_back({0, at(i + 1, 1), at(i, 1)});
    mesh.triangles.push_back({1, at(i, up - 1), at(i + 1, up - 1)});
    for (std::uint32_t j = 1; j + 1 < up; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

/// A square n x n cells, from (0, 0, 0) along x and y, normal z.
inline TriangleMesh square(std::uint32_t n) {
  TriangleMesh mesh;
  for (std::uint32_t j = 0; j <= n; ++j)
    for (std::uint32_t i = 0; i <= n; ++i)
      mesh.vertices.points.push_back({static_cast<double>(i) / n, static_cast<double>(j) / n, 0});
  for (std::uint32_t j = 0; j < n; ++j)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t v = j * (n + 1) + i;
      mesh.triangles.push_back({v, v + 1, v + n + 2});
      mesh.triangles.push_back({v, v + n + 2, v + n + 1});
    }
  return mesh;
}

}  // namespace spigolo
