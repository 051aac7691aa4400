// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/index/sample.h - some points of a cloud to look at where all of them would be too many
#pragma once

#include <cstdint>
#include <vector>

#include "spigolo/index/spacing.h"

namespace spigolo {

/// A number as if by chance, any 32 bits, that is the same in a cloud that was turned, moved or
/// scaled: it depends on the spacing of the point only. The spacing of the cloud must not be 0.
std::uint32_t chance_number(const Spacing& spacing, std::size_t i);

/// About `asked` points in canonical order, as if by chance: which ones is decided by their
/// spacing, so that they are the same ones in a cloud that was turned, moved or scaled. All points
/// if there are no more. Of lattices, whose spacings are alike, evenly along the canonical order.
std::vector<std::uint32_t> sample_points(const Spacing& spacing, std::size_t asked);

}  // namespace spigolo
