// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/leftovers.h - samples that a surface passes by, to be meshed apart
#pragma once

#include <cstdint>
#include <vector>

#include "spigolo/mesh/samples.h"
#include "spigolo/mesh/sides.h"

namespace spigolo {

/// Samples that are no vertex of the triangles and lie away from all that are: a wall that ends in
/// another one, a second body that touches the first. With them those beside them that are no
/// vertices either. Ascending; empty if there are too few to be a sheet.
std::vector<std::uint32_t> left_out(const MeshSamples& samples,
                                    const std::vector<Triangle>& triangles);

/// These sheet samples, and the crease segments beside which one of them shows a sheet.
MeshSamples take_samples(const MeshSamples& samples, const CreaseSides& sides,
                         const std::vector<std::uint32_t>& which);

/// How many points of the cloud lie more than two edges from all vertices of the triangles.
std::size_t count_uncovered(const SurfacePoints& surface, const std::vector<Vec3>& vertices,
                            const std::vector<Triangle>& triangles, double step);

}  // namespace spigolo
