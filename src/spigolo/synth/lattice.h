// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/lattice.h - regular grids on shapes, with samples exactly on their edges
#pragma once

#include <functional>
#include <vector>

#include "spigolo/core/geometry.h"

namespace spigolo {

/// A solid made of unit cells; says whether cell (i, j, k) is solid, false outside of the extent.
struct CellSolid {
  int nx = 1, ny = 1, nz = 1;
  std::function<bool(int i, int j, int k)> solid;
};

/// The lattice points on the surface of the solid: every cell is divided into steps x steps x
/// steps, coordinates are (i, j, k) * unit / steps. In lexicographic order.
std::vector<Vec3> surface_lattice(const CellSolid& cells, int steps, double unit);

/// Faces of cells between solid and empty. A closed lattice of quads around a solid ball has
/// faces * steps^2 + 2 points.
std::size_t surface_faces(const CellSolid& cells);

/// One massive block.
CellSolid block(int nx, int ny, int nz);

}  // namespace spigolo
