// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/surfels.h - the little discs points stand for
#pragma once

#include <span>
#include <vector>

#include "spigolo/core/geometry.h"
#include "spigolo/core/job.h"

namespace spigolo {

/// How large a disc each point stands for, and how it lies.
struct Surfels {
  std::vector<float> spacings;  // [model unit] one per point, or a single one for all
  std::vector<Vec3> normals;    // unit, of either sign, one per point; or empty: not known
};

/// From the nearest neighbors of each point: planes that let go of what lies past a crease. Points
/// that are not finite get spacing 0.
Surfels find_surfels(std::span<const Vec3> points, const Job& job);

}  // namespace spigolo
