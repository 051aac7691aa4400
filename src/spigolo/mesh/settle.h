// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/settle.h - vertices moved a hair where triangles touch that should not
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "spigolo/core/geometry.h"
#include "spigolo/core/job.h"
#include "spigolo/mesh/edges.h"

namespace spigolo {

/// A surface that does not run into itself with its vertices at safe(v) may do so a hair beside, at
/// `points`: triangles without height, or two that touch, on parts that are exactly flat or
/// straight. There, and around as far as it takes, the vertices are moved to their safe place.
/// Returns how many were.
std::size_t settle(std::span<const Triangle> triangles, std::vector<Vec3>& points,
                   const std::function<Vec3(std::uint32_t)>& safe, const Job& job = {});

}  // namespace spigolo
