// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/trim.h - triangles that no sample supports, and the holes that are left
#pragma once

#include <cstdint>
#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/mesh/check.h"
#include "spigolo/mesh/openness.h"

namespace spigolo {

/// The label of a closed body closes open scans as well, by triangles that run across empty space.
/// Takes away those that are longer than three edges or steeper against their sheets than 55
/// degrees, where they hang together and the long ones span more than `largest_hole` [steps]; other
/// groups are gaps in the samples and stay. Then scraps of fewer than `least_piece` triangles go.
/// Returns how many were taken.
struct TrimOptions {
  double largest_hole = 8;
  std::size_t least_piece = 8;
};
std::size_t trim_unsupported(std::vector<Triangle>& triangles, const MeshSamples& samples,
                             const Openness& openness, const TrimOptions& options);

/// Takes away pieces, joined over edges, of fewer than `least` triangles.
void drop_scraps(std::vector<Triangle>& triangles, std::size_t vertices, std::size_t least);

/// The vertices of a border, once around, such that triangles which close it run along.
using BorderLoop = std::vector<std::uint32_t>;

/// Borders that visit no vertex twice.
std::vector<BorderLoop> find_border_loops(const std::vector<Triangle>& triangles,
                                          std::size_t vertices);

/// Edges of the longest loop that is filled: the time grows with the cube.
inline constexpr std::size_t longest_loop = 2000;

/// The triangulation of least area over the points of a loop; empty for more than `longest_loop`.
std::vector<Triangle> fill_loop(const std::vector<Vec3>& loop, const Job& job = {});

/// Closes border loops not wider than `largest` (in units of the points, infinite: all) by the
/// triangulation of least area, which adds no vertex. Loops that visit a vertex twice, those of
/// more than `longest_loop` edges and those whose filling would run into the mesh stay. Returns how
/// many were closed.
std::size_t fill_holes(std::vector<Triangle>& triangles, const std::vector<Vec3>& points,
                       double largest, const Job& job = {});

/// Takes away the triangles at edges with more than two of them, those without height, those that
/// run into each other, then pieces of fewer than eight triangles. Returns how many were taken.
std::size_t take_faults(std::vector<Triangle>& triangles, const std::vector<Vec3>& points,
                        const Job& job = {});

}  // namespace spigolo
