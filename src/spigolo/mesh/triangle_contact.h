// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/triangle_contact.h - do two triangles of a mesh run into each other?
#pragma once

#include <array>

#include "spigolo/core/geometry.h"

namespace spigolo {

using TrianglePoints = std::array<Vec3, 3>;

/// Whether two triangles with area have a point in common beyond the corners and edges they share;
/// corners are shared if their coordinates are equal. Touching counts. Exact.
bool run_into_each_other(const TrianglePoints& a, const TrianglePoints& b);

}  // namespace spigolo
