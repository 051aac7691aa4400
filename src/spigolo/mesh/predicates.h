// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/predicates.h - on which side a point lies, without rounding errors
#pragma once

#include "spigolo/core/geometry.h"

namespace spigolo {

/// Sign (-1, 0, 1) of the determinant of (a - d, b - d, c - d): positive if a, b, c run clockwise
/// seen from d, 0 exactly if the four lie in one plane. Right for all finite coordinates whose
/// products neither overflow nor underflow.
int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// The same in the coordinate plane that is left when `axis` (0 to 2) is dropped: positive if a, b,
/// c run counterclockwise, x before y before z before x.
int orient2d(const Vec3& a, const Vec3& b, const Vec3& c, std::size_t axis);

}  // namespace spigolo
