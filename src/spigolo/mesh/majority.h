// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/majority.h - which way each sample looks, when many say so and some are wrong
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace spigolo {

/// The normals of two samples look to the same side of the surface (differ 0) or not (1).
struct Claim {
  std::uint32_t a = 0, b = 0;
  std::uint8_t differ = 0;
  float doubt = 0;  // in [0, 1)
};

/// One sign a sample (0 or 1), such that signs differ where claims say so, as far as the weight of
/// the claims can have it: one wrong claim is outvoted wherever two parts touch along a line.
/// Samples that no chain of claims joins have unrelated signs. claims name samples below `samples`,
/// never one twice.
std::vector<std::uint8_t> settle_by_majority(const std::vector<Claim>& claims, std::size_t samples);

}  // namespace spigolo
