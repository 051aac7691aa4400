// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/patch.h - strands without a place of their own, put between their neighbors
#pragma once

#include "spigolo/blend/cloud_side.h"
#include "spigolo/blend/strand.h"

namespace spigolo {

/// good: of each strand, whether its beta was found; at least one. The others get one between the
/// nearest good ones, on the cloud. Returns how many.
std::size_t patch_betas(const CloudSide& cloud, const std::vector<char>& good, BorderLoop& loop);

/// Alphas too, each on its own isoline.
std::size_t patch_strands(const Isolines& isolines, const CloudSide& cloud,
                          const std::vector<char>& good, BorderLoop& loop);

}  // namespace spigolo
