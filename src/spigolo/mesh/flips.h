// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/flips.h - better triangles over the same vertices
#pragma once

#include <span>
#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/mesh/check.h"

namespace spigolo {

struct FlipReport {
  std::size_t flipped = 0;             // edges
  std::size_t border_slivers = 0;      // flat triangles taken off borders
  std::size_t self_intersections = 0;  // pairs of triangles, after all flips
};

/// Takes triangles of no height off the borders, then flips edges to the other diagonal of their
/// two triangles where the angles opposite to them add up to more than a half turn and the two are
/// nearly in one plane: the Delaunay triangulation of flat parts. Creases stay. Triangles that are
/// not manifold or not oriented are left alone. Where triangles run into each other afterwards, the
/// edges around them stay as they were.
FlipReport flip_edges(std::vector<Triangle>& triangles, const std::vector<Vec3>& points,
                      std::span<const VertexPair> creases, const Job& job = {});

}  // namespace spigolo
