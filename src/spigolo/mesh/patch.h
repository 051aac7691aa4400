// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/patch.h - a triangulated hole: even triangles, then the shape
#pragma once

#include <cstdint>
#include <vector>

#include "spigolo/core/geometry.h"
#include "spigolo/mesh/edges.h"

namespace spigolo {

/// Triangles that fill a loop. Points 0 to border - 1 are those of the loop, which stay.
struct HolePatch {
  std::vector<Vec3> points;
  std::size_t border = 0;
  std::vector<Triangle> triangles;
};

/// Adds vertices until edges are about `step` long, and turns edges so that triangles are even.
void refine(HolePatch& patch, double step);

/// The film of least tension: a soap film.
void relax_film(HolePatch& patch);

/// A plate that continues what is beyond the border: beyond.neighbors[i] are the neighbors of
/// border point i outside the hole.
struct Beyond {
  std::vector<std::vector<Vec3>> neighbors;
  double bending = 0;  // [1 / unit] mean curvature there, positive where the surface is convex
};
void relax_plate(HolePatch& patch, const Beyond& beyond, double step);

double area(const HolePatch& patch);

}  // namespace spigolo
