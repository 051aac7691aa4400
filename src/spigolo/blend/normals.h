// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/normals.h - normals of the cloud that agree about the outside
#pragma once

#include <span>
#include <vector>

#include "spigolo/blend/cloud_side.h"
#include "spigolo/blend/strand.h"

namespace spigolo {

/// Unit normals of the samples in canonical order. Signs are carried from sample to sample, the
/// flattest step first; each connected piece as a whole has either sign.
struct CloudNormals {
  std::vector<Vec3> normal;
  std::vector<std::uint32_t> piece;
  std::size_t pieces = 0;
};
CloudNormals find_normals(const CloudSide& cloud, const Job& job);

/// How often the surface runs round p, by the solid angle it fills: 1 or -1 inside a closed one, 0
/// outside, something between at an open one.
double winding_number(const CloudSide& cloud, const CloudNormals& normals, const Vec3& p);

/// Turns each piece so that it agrees with the strands that end on it; other pieces stay.
void point_outward(const CloudSide& cloud, std::span<const BorderLoop> loops,
                   CloudNormals& normals);

}  // namespace spigolo
