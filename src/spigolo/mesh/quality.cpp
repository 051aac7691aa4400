// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/quality.cpp
#include "spigolo/mesh/quality.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace spigolo {
namespace {

const double slim_angle = radians(20);
constexpr double worst_aspect = 1e6;  // of a triangle without height

struct OneTriangle {
  double angle = 0, aspect = worst_aspect;
  std::array<double, 3> edges{};
};

OneTriangle measure(const Vec3& a, const Vec3& b, const Vec3& c) {
  OneTriangle one;
  one.edges = {distance(a, b), distance(b, c), distance(c, a)};
  one.angle = std::min(
      {angle_between(b - a, c - a), angle_between(a - b, c - b), angle_between(a - c, b - c)});
  const double longest = *std::max_element(one.edges.begin(), one.edges.end());
  const double doubled = norm(cross(b - a, c - a));
  if (doubled > 0) one.aspect = std::min(worst_aspect, longest * longest / doubled);
  return one;
}

}  // namespace

TriangleQuality measure_quality(const TriangleMesh& mesh) {
  TriangleQuality q;
  if (mesh.triangles.empty()) return q;
  const auto& p = mesh.vertices.points;
  std::vector<double> angles;
  double edge = 0, squared = 0, aspect = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const OneTriangle one = measure(p[a], p[b], p[c]);
    angles.push_back(one.angle);
    aspect += one.aspect;
    for (const double e : one.edges) edge += e, squared += e * e;
    q.angle_mean += one.angle;
    q.slim += one.angle < slim_angle ? 1 : 0;
  }
  const auto n = static_cast<double>(angles.size());
  q.angle_mean /= n, q.slim /= n, q.aspect_mean = aspect / n;
  q.edge_mean = edge / (3 * n);
  q.edge_deviation = std::sqrt(std::max(0.0, squared / (3 * n) - q.edge_mean * q.edge_mean));
  const auto p5 = angles.begin() + static_cast<std::ptrdiff_t>(angles.size() / 20);
  std::nth_element(angles.begin(), p5, angles.end());
  q.angle_p5 = *p5;
  q.angle_least = *std::min_element(angles.begin(), angles.end());
  return q;
}

}  // namespace spigolo
