// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/sampling.h - how far the points of a layer lie apart
#pragma once

#include <span>
#include <vector>

#include "spigolo/core/geometry.h"
#include "spigolo/core/job.h"

namespace spigolo {

/// The local spacing [model unit] of each point, from how many points share the cells of a grid
/// round it: root of area per point. One value for all if every point is alone or they coincide
/// (then 0). Good to a third, in a fraction of a second for a million points: enough for the size
/// of splats.
std::vector<float> local_spacings(std::span<const Vec3> points, const Job& job);

}  // namespace spigolo
