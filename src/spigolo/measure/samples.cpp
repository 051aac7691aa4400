// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/measure/samples.cpp
#include "spigolo/measure/samples.h"

#include <algorithm>
#include <cmath>

namespace spigolo {
namespace {

// Pieces of at most step; 1 for what is short or not finite.
int pieces_of(double length, double step) {
  return std::isfinite(length) && length > step ? static_cast<int>(std::ceil(length / step)) : 1;
}

}  // namespace

std::vector<Vec3> places_between(const TriangleMesh& mesh, double step) {
  const std::vector<Vec3>& v = mesh.vertices.points;
  std::vector<Vec3> places;
  for (const auto& [i, j, k] : mesh.triangles) {
    const Vec3 &a = v[i], &b = v[j], &c = v[k];
    const int n = pieces_of(std::max({distance(a, b), distance(b, c), distance(c, a)}), step);
    for (int row = 0; row <= n; ++row)
      for (int column = 0; row + column <= n; ++column) {
        const bool corner = row == n || column == n || (row == 0 && column == 0);
        if (!corner)
          places.push_back(a + (b - a) * (double(row) / n) + (c - a) * (double(column) / n));
      }
  }
  return places;
}

std::vector<Vec3> places_between(std::span<const Vec3> points, const Segments& segments,
                                 double step) {
  std::vector<Vec3> places;
  for (const auto& [i, j] : segments) {
    const Vec3 &a = points[i], &b = points[j];
    const int n = pieces_of(distance(a, b), step);
    for (int piece = 1; piece < n; ++piece) places.push_back(a + (b - a) * (double(piece) / n));
  }
  return places;
}

double area_of(const TriangleMesh& mesh) {
  const std::vector<Vec3>& v = mesh.vertices.points;
  double area = 0;
  for (const auto& [i, j, k] : mesh.triangles) {
    const double part = norm(cross(v[j] - v[i], v[k] - v[i])) / 2;
    if (std::isfinite(part)) area += part;
  }
  return area;
}

double length_of(std::span<const Vec3> points, const Segments& segments) {
  double length = 0;
  for (const auto& [i, j] : segments) {
    const double part = distance(points[i], points[j]);
    if (std::isfinite(part)) length += part;
  }
  return length;
}

}  // namespace spigolo
