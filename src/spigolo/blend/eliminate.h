// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/eliminate.h - thinning to an even density (thesis §5.4.2.4), in no order
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "spigolo/core/geometry.h"
#include "spigolo/core/job.h"

namespace spigolo {

/// Tells the points that stay anyway within a radius: calls back with each one's squared distance.
/// Used by many threads at once.
using FixedPoints = std::function<void(const Vec3& p, double radius,
                                       const std::function<void(double squared_distance)>& visit)>;

/// Weighted sample elimination (Yuksel 2015): takes away the candidate most crowded by others and
/// by the fixed points, until `wanted` are left; then some come back where else none would be
/// within a spacing. Ties go by the canonical order, so the result does not depend on the order of
/// the candidates. spacing: 1 / sqrt(density) that is wanted; the wanted number should suit it.
/// Candidates in one place count once. Returns which ones stay.
std::vector<char> eliminate(std::span<const Vec3> candidates, std::size_t wanted, double spacing,
                            const FixedPoints& fixed, const Job& job);

}  // namespace spigolo
