// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/colours.h - the three scales on which text formats write colours
#pragma once

#include <vector>

#include "spigolo/core/point_cloud.h"

namespace spigolo {

/// Appends red, green, blue (and alpha, if there is a fourth channel) as uint8. Channels whose
/// values all lie in [0, 1] are taken times 255; `whole` says that the file had them as whole
/// numbers, which then are 0..255 already.
void add_colours(PointCloud& cloud, std::vector<std::vector<double>> channels, bool whole);

/// The attributes red, green, blue if all three are there as uint8, else nothing.
std::vector<const Attribute*> find_colours(const PointCloud& cloud);

}  // namespace spigolo
