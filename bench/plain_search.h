// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/plain_search.h - the nearest neighbors of all points and nothing else: what times are
// measured in
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "spigolo/core/geometry.h"

namespace spigolo::bench {

/// CPU seconds of the k nearest neighbors of every point on one core, in our order, the building of
/// the tree apart.
double search_seconds(std::span<const Vec3> points, std::size_t k);

/// The same by nanoflann, in the order of the points.
double nanoflann_seconds(const std::vector<Vec3>& points, std::size_t k);

}  // namespace spigolo::bench
