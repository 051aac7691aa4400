// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/linear.h - the thesis's collar, word by word (§5.4.2.1 to 5.4.2.4)
#pragma once

#include "spigolo/blend/fill.h"

namespace spigolo {

struct LinearBorder {
  std::vector<FilledPoint> points;  // S, then the thinned C
  BorderLoop loop;                  // a strand for each alpha and its beta
};

/// Samples the face along its isolines with the mean distance of nearest samples, stops each line
/// at the last place not nearer than the height to a sample (alpha), doubles the alphas, removes
/// the samples within the width of an alpha or of the way from the first alpha to another, takes
/// the nearest remaining samples (beta), fills their gaps, joins each alpha with three betas by
/// straight lines and thins these in random order. Adds to `removed` (canonical order). Throws
/// NoResultError if lines run through the cloud: the height is then below its spacing.
LinearBorder linear_border(const CloudSide& cloud, const TracedStart& traced,
                           const Setbacks& setbacks, std::uint32_t border, std::uint64_t seed,
                           std::vector<char>& removed);

}  // namespace spigolo
