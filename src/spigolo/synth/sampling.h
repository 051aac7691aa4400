// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/sampling.h - samples of a shape off any lattice, their spacing, their noise
#pragma once

#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/synth/shape.h"

namespace spigolo {

/// Independent samples, uniform by area.
std::vector<Vec3> sample_random(const Shape& shape, std::size_t count, Random& random);

/// Random samples of which no two are nearer than .75 sqrt(area / count), by dart throwing over the
/// whole surface. Where that many do not fit (sheets closer than the spacing) the distance shrinks
/// until they do. Throws Cancelled.
std::vector<Vec3> sample_blue(const Shape& shape, std::size_t count, Random& random,
                              const Job& job);

/// Median distance of the points to their nearest other one; expected: about its size.
/// 0 for fewer than two points.
double median_spacing(const std::vector<Vec3>& points, double expected, const Job& job);

}  // namespace spigolo
