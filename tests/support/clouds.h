// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/support/clouds.h - point sets that have broken neighbor searches before
#pragma once

#include <string>
#include <vector>

#include "spigolo/core/geometry.h"
#include "spigolo/core/random.h"

namespace spigolo::test {

struct NamedPoints {
  std::string name;
  std::vector<Vec3> points;
};

/// A square lattice in the plane z = 0: every distance comes in ties.
inline std::vector<Vec3> square_lattice(int n, double h = 1) {
  std::vector<Vec3> points;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) points.push_back({i * h, j * h, 0});
  return points;
}

inline std::vector<Vec3> cubic_lattice(int n) {
  std::vector<Vec3> points;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) points.push_back({double(i), double(j), double(k)});
  return points;
}

/// n points uniform on the unit square.
inline std::vector<Vec3> random_square(int n, std::uint64_t seed) {
  Random random(seed);
  std::vector<Vec3> points;
  for (int i = 0; i < n; ++i) points.push_back({random.uniform(), random.uniform(), 0});
  return points;
}

inline std::vector<Vec3> random_sphere(int n, std::uint64_t seed, double radius = 1) {
  Random random(seed);
  std::vector<Vec3> points;
  for (int i = 0; i < n; ++i) points.push_back(random.on_sphere() * radius);
  return points;
}

/// Clumps of points a millionth apart, far from each other.
inline std::vector<Vec3> clumps(std::uint64_t seed) {
  Random random(seed);
  std::vector<Vec3> points;
  for (int c = 0; c < 12; ++c) {
    const Vec3 center = random.on_sphere() * 1000.0;
    for (int i = 0; i < 60; ++i) points.push_back(center + random.in_ball() * 1e-6);
  }
  return points;
}

/// Dense cluster, sparse surroundings and a few points very far away.
inline std::vector<Vec3> uneven(std::uint64_t seed) {
  Random random(seed);
  std::vector<Vec3> points;
  for (int i = 0; i < 800; ++i) points.push_back(random.in_ball() * 0.01);
  for (int i = 0; i < 400; ++i) points.push_back(random.in_ball() * 10.0);
  for (int i = 0; i < 9; ++i) points.push_back(random.on_sphere() * 1e7);
  return points;
}

inline std::vector<Vec3> moved(std::vector<Vec3> points, const Vec3& offset) {
  for (Vec3& p : points) p += offset;
  return points;
}

inline std::vector<Vec3> repeated(const std::vector<Vec3>& points) {
  std::vector<Vec3> twice;
  for (std::size_t i = 0; i < points.size(); ++i) {
    twice.push_back(points[i]);
    if (i % 3 == 0) twice.push_back(points[i]);
  }
  return twice;
}

inline std::vector<NamedPoints> hard_clouds() {
  return {{"square lattice", square_lattice(40)},
          {"cubic lattice", cubic_lattice(10)},
          {"random square", random_square(2000, 1)},
          {"sphere", random_sphere(2000, 2)},
          {"clumps", clumps(3)},
          {"uneven", uneven(4)},
          {"far from zero", moved(random_sphere(1500, 5), {6e6, 5e6, 400})},
          {"tiny",
           [] {
             auto p = random_sphere(500, 6, 1e-30);
             return p;
           }()},
          {"huge", random_sphere(500, 7, 1e30)},
          {"repeated", repeated(square_lattice(25))},
          {"line",
           [] {
             std::vector<Vec3> p;
             for (int i = 0; i < 300; ++i) p.push_back({double(i), 2.0 * i, -1.0 * i});
             return p;
           }()},
          {"one", {{1, 2, 3}}},
          {"two", {{1, 2, 3}, {1, 2, 4}}},
          {"equal", std::vector<Vec3>(50, Vec3{1, 1, 1})}};
}

/// The same points in another order.
template <typename T>
std::vector<T> shuffled(std::vector<T> values, std::uint64_t seed) {
  Random random(seed);
  for (std::size_t i = values.size(); i > 1; --i) std::swap(values[i - 1], values[random.below(i)]);
  return values;
}

}  // namespace spigolo::test
