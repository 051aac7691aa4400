// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/pipeline/cone_tips.h - where exactly the tips of cones are
#pragma once

#include <span>
#include <vector>

#include "spigolo/core/feature_curves.h"
#include "spigolo/core/features.h"

namespace spigolo {

/// The apex of each cone that points are labelled `tip` of, by least squares: labels know it to
/// some tenths of a spacing only, and a label that no right circular cone bears out may be wrong.
/// Without a label, where points called sharp lie on no curve of the network but, with all around
/// them, on a cone. spacing: in units of the points; noise: in spacings.
std::vector<Vec3> find_cone_tips(std::span<const Vec3> points, const Features& features,
                                 const FeatureCurves& network, double spacing, double noise);

}  // namespace spigolo
