// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/fold_sums.h - sums over the points of a neighborhood that tell how well a fold
// fits
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace spigolo {

/// Of a point, or of all points in a bin: how many, what a quadric leaves of the height, and the
/// six terms of the quadric's orthonormal basis. Added together entry by entry.
using FoldRow = std::array<double, 8>;

/// The heights of a fold at signed distances from its line: sqrt(s^2 + roundness^2), in place.
void fold_heights(std::span<double> distances, double roundness);

/// bins[bin[i]] += rows[i], in the order of i.
void add_to_bins(std::span<const FoldRow> rows, std::span<const std::uint32_t> bin,
                 std::span<FoldRow> bins);

/// Of sums.size() folds at once, heights[i * sums.size() + o] the height of fold o at row i:
/// sums[o] = sum of rows[i] * height, the count times its square, in the order of i; so the bits do
/// not depend on the instruction set.
void sum_folds(std::span<const FoldRow> rows, std::span<const double> heights,
               std::span<FoldRow> sums);

}  // namespace spigolo
