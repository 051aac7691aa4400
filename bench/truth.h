// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/truth.h - more of what is true of a constructed cloud
#pragma once

#include <vector>

#include "spigolo/synth/synth.h"

namespace spigolo::bench {

/// sqrt(area / samples).
double mean_spacing(const SynthCloud& cloud);

/// Unit normal, sign arbitrary, of the surface where it is nearest to p.
Vec3 true_normal(const Shape& shape, const Vec3& p);

/// Places on the edges, every half spacing.
std::vector<Vec3> edge_places(const Shape& shape, double spacing);

}  // namespace spigolo::bench
