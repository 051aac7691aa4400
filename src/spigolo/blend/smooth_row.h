// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/smooth_row.h - corners of a row of points made round, its bends left as they are
#pragma once

#include <vector>

#include "spigolo/core/geometry.h"

namespace spigolo {

/// Each point moves to 2 G(row) - G(G(row)), where G is a Gaussian mean over the length of the row
/// with that standard deviation: bends much wider than sigma stay, corners become round within
/// about two sigma.
std::vector<Vec3> round_corners(const std::vector<Vec3>& row, double sigma, bool closed);

}  // namespace spigolo
