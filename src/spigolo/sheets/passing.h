// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/passing.h - with noise: how likely does a crease pass the place a sample was
// taken?
#pragma once

#include "spigolo/sheets/verdict.h"

namespace spigolo {

/// A noisy sample may come from any place of the two half planes beside the crease of `edge` (an
/// edge verdict), the less likely the farther off. All places being equally likely beforehand: the
/// probability that its own lies within `near` [spacings] of the crease. Only what the noise did
/// along the sheets matters, not how far off them the sample lies. noise: standard deviation along
/// each axis [spacings], above 0.
double passing_probability(const SheetVerdict& edge, const Vec3& sample, double spacing,
                           double near, double noise);

}  // namespace spigolo
