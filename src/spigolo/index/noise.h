// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/index/noise.h - how far the samples lie off the surface
#pragma once

#include <cstdint>
#include <span>

#include "spigolo/core/job.h"
#include "spigolo/index/kd_tree.h"
#include "spigolo/index/neighborhoods.h"
#include "spigolo/index/spacing.h"

namespace spigolo {

/// Standard deviation of the samples across the surface, in spacings: the smallest of three local
/// estimates, since each errs upward where its model does not hold. A plane through 9 points errs
/// on curved surfaces, a quadric through 17 on thin walls, the flattest half of 16 neighbors (least
/// median of squares over planes through the point) on strong curvature only. Each is taken at its
/// lower quartile over the cloud, where no crease is near, and corrected for the freedom its fit
/// has; large noise, of which small neighborhoods show only a part, is corrected for that. Above
/// 0.4 a quadric through 65 points may find less: of even samples shaken across the surface only,
/// the others see too much. 0 if there are too few points. Looks at about 20 000 points at
/// most, as sample_points has them.
double estimate_noise(std::span<const Vec3> points, const Neighborhoods& neighborhoods,
                      const Spacing& spacing, const KdTree& tree, const Job& job = {});

/// Noise at one point [spacings], from the flattest half of its 16 nearest neighbors: twice the
/// smallest median distance to a plane through it and two of them (least median of squares,
/// Rousseeuw 1984). Not misled while half of them lie on one flat sheet. row: at least 16.
double noise_of_flattest_half(std::span<const Vec3> points, std::size_t i,
                              std::span<const std::uint32_t> row, double spacing);

}  // namespace spigolo
