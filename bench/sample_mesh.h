// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/sample_mesh.h - random samples of a triangle mesh, uniform by area
#pragma once

#include <vector>

#include "spigolo/core/triangle_mesh.h"

namespace spigolo::bench {

std::vector<Vec3> sample_mesh(const TriangleMesh& mesh, std::size_t count, std::uint64_t seed);

}  // namespace spigolo::bench
