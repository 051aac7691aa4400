// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/lattice.cpp - regular grids on the surfaces of cell solids
#include "spigolo/synth/lattice.h"

#include "spigolo/core/error.h"

namespace spigolo {
namespace {

bool is_solid(const CellSolid& cells, int i, int j, int k) {
  return i >= 0 && j >= 0 && k >= 0 && i < cells.nx && j < cells.ny && k < cells.nz &&
         cells.solid(i, j, k);
}

/// Whether the lattice point (i, j, k) touches both a solid and an empty cell.
bool on_surface(const CellSolid& cells, int steps, const int (&p)[3]) {
  int low[3], high[3];  // the cells at the point along each axis
  for (int a = 0; a < 3; ++a) high[a] = p[a] / steps, low[a] = high[a] - (p[a] % steps == 0);
  bool any = false, all = true;
  for (int i = low[0]; i <= high[0]; ++i)
    for (int j = low[1]; j <= high[1]; ++j)
      for (int k = low[2]; k <= high[2]; ++k) {
        const bool here = is_solid(cells, i, j, k);
        any = any || here, all = all && here;
      }
  return any && !all;
}

}  // namespace

std::vector<Vec3> surface_lattice(const CellSolid& cells, int steps, double unit) {
  std::vector<Vec3> points;
  auto at = [&](int i) { return i * unit / steps; };
  for (int i = 0; i <= cells.nx * steps; ++i)
    for (int j = 0; j <= cells.ny * steps; ++j) {
      // a point off all cell faces of i and j can only lie on one of k
      const int stride = i % steps == 0 || j % steps == 0 ? 1 : steps;
      for (int k = 0; k <= cells.nz * steps; k += stride)
        if (on_surface(cells, steps, {i, j, k})) points.push_back({at(i), at(j), at(k)});
    }
  return points;
}

std::size_t surface_faces(const CellSolid& cells) {
  std::size_t faces = 0;
  for (int i = 0; i <= cells.nx; ++i)
    for (int j = 0; j <= cells.ny; ++j)
      for (int k = 0; k <= cells.nz; ++k) {
        const bool here = is_solid(cells, i, j, k);
        faces += here != is_solid(cells, i - 1, j, k);
        faces += here != is_solid(cells, i, j - 1, k);
        faces += here != is_solid(cells, i, j, k - 1);
      }
  return faces;
}

CellSolid block(int nx, int ny, int nz) {
  return {nx, ny, nz, [](int, int, int) { return true; }};
}

}  // namespace spigolo
