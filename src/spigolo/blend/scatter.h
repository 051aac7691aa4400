// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/scatter.h - random places on a surface, uniform by area
#pragma once

#include <functional>
#include <vector>

#include "spigolo/core/geometry.h"
#include "spigolo/core/job.h"
#include "spigolo/core/random.h"

namespace spigolo {

/// A surface over [0, rows] x [0, columns], cut into cells by the whole numbers.
struct CellGrid {
  std::size_t rows = 0, columns = 0;
  std::function<Vec3(double row, double column)> point;  // called by many threads at once
};

struct GridPlace {
  double row = 0, column = 0;
};

/// About density x area places, uniform by the areas of the cells; the same for any number of
/// threads. area: receives that of all cells.
std::vector<GridPlace> scatter(const CellGrid& grid, double density, Random& random, double& area,
                               const Job& job);

}  // namespace spigolo
