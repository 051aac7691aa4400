// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/feature_cloud.h - verdicts as attributes of a cloud, as detect writes them
#pragma once

#include <string>

#include "spigolo/core/features.h"
#include "spigolo/core/point_cloud.h"

namespace spigolo {

/// red green blue by kind, quality, scalar_kind, scalar_angle [degrees], scalar_convex,
/// scalar_curve, edge_x edge_y edge_z, scalar_sheets, direction_x direction_y direction_z; then the
/// attributes the cloud came with, except those of these names.
PointCloud with_features(PointCloud cloud, const Features& features);

/// The kinds in an attribute of such a cloud; anything that is no kind counts as surface.
std::vector<PointKind> kinds_of(const Attribute& attribute);

/// Labels read back from a cloud that detect wrote, for the points of `cloud`. file: for messages.
/// Throws InputError if there is no scalar_kind, or if the points are others than those of `cloud`
/// (farther away than a millionth of its size, which float coordinates explain).
Features features_of(const PointCloud& labels, const PointCloud& cloud, const std::string& file);

}  // namespace spigolo
