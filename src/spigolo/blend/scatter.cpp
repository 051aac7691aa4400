// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/scatter.cpp
#include "spigolo/blend/scatter.h"

#include <cmath>

#include "spigolo/core/parallel.h"

namespace spigolo {
namespace {

constexpr std::size_t grain = 16;  // rows

double triangle_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  return norm(cross(b - a, c - a)) / 2;
}

std::vector<Vec3> corners(const CellGrid& grid, const Job& job) {
  const std::size_t width = grid.columns + 1;
  std::vector<Vec3> points((grid.rows + 1) * width);
  parallel_for(job, "", grid.rows + 1, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      for (std::size_t j = 0; j < width; ++j)
        points[i * width + j] = grid.point(static_cast<double>(i), static_cast<double>(j));
  });
  return points;
}

}  // namespace

std::vector<GridPlace> scatter(const CellGrid& grid, double density, Random& random, double& area,
                               const Job& job) {
  const std::vector<Vec3> points = corners(grid, job);
  const std::size_t width = grid.columns + 1;
  std::vector<GridPlace> places;
  area = 0;
  double given = 0;
  for (std::size_t i = 0; i < grid.rows; ++i)
    for (std::size_t j = 0; j < grid.columns; ++j) {
      const Vec3 &a = points[i * width + j], &b = points[i * width + j + 1],
                 &c = points[(i + 1) * width + j], &e = points[(i + 1) * width + j + 1];
      area += (triangle_area(a, b, c) + triangle_area(b, e, c) + triangle_area(a, b, e) +
               triangle_area(a, e, c)) /
              2;
      for (; given + 1 <= area * density; given += 1)
        places.push_back(
            {static_cast<double>(i) + random.uniform(), static_cast<double>(j) + random.uniform()});
    }
  return places;
}

}  // namespace spigolo
