// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/index/noise.h - how far the samples lie off the surface
#pragma once

#include <span>

#include "spigolo/core/job.h"
#include "spigolo/index/neighborhoods.h"
#include "spigolo/index/spacing.h"

namespace spigolo {

/// Standard deviation of the samples across the surface, in spacings. The residuals of two local
/// models are corrected for the freedom each fit has and taken at their lower quartile, where no
/// crease is in the neighborhood: a plane through 9 points (errs on curved surfaces) and a quadric
/// through 17 (errs on thin walls). Both err upward, so the smaller one counts.
/// 0 if there are too few points. Looks at 20 000 points at most, evenly along the canonical order.
double estimate_noise(std::span<const Vec3> points, const Neighborhoods& neighborhoods,
                      const Spacing& spacing, const Job& job = {});

}  // namespace spigolo
