// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/pipeline/cone_tips.h - where exactly the tips of cones are
#pragma once

#include <span>
#include <vector>

#include "spigolo/core/features.h"

namespace spigolo {

/// Places that points labelled `tip` name, each once. Where the points around lie on a right
/// circular cone, its apex, by least squares: labels know it to some tenths of a spacing only.
/// spacing: in units of the points; noise: in spacings.
std::vector<Vec3> find_cone_tips(std::span<const Vec3> points, const Features& features,
                                 double spacing, double noise);

}  // namespace spigolo
