// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/index/spacing.h - how far apart the samples of a surface are
#pragma once

#include <span>
#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/index/neighborhoods.h"

namespace spigolo {

/// The spacing is 1 / sqrt(samples per area): the constant of a square lattice of that density. It
/// is read off the k nearest neighbors, which fill a disc of area pi r_k^2, so random samples and
/// lattices of one density get the same spacing; the distance to the nearest neighbor would not do
/// that (0.5 of it on random samples).
struct Spacing {
  std::vector<double> of_point;  // canonical order; 0 where there are no neighbors
  double of_cloud = 0;           // their median
  /// Share of the points whose two nearest neighbors lie close by, before and behind them: most of
  /// them on scan lines that are denser along than across, one in twenty at random.
  double on_lines = 0;
};

/// Uses the first 12 neighbors of each row, or all if there are fewer.
Spacing estimate_spacing(std::span<const Vec3> points, const Neighborhoods& neighborhoods,
                         const Job& job = {});

}  // namespace spigolo
