// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/cad/nurbs_shapes.h - exact control nets of simple surfaces, for tests and examples
#pragma once

#include <functional>
#include <span>

#include "spigolo/cad/nurbs_surface.h"

namespace spigolo {

/// Where a tube begins and which way it goes; axis is unit.
struct TubeFrame {
  Vec3 origin, axis;
};

/// Round tube or cone frustum: u in [0, 1] runs round (period 1), v in [0, 1] along the axis. Its
/// normals point away from the axis.
NurbsSurface nurbs_tube(const TubeFrame& frame, double radius, double length);
NurbsSurface nurbs_cone(const TubeFrame& frame, double radius, double end_radius, double length);

/// A tube bent by half a turn: leg, half a torus, leg back. `side` (unit, perpendicular to the
/// axis) points from the first leg to the second, which are `gap` apart (axis to axis).
NurbsSurface nurbs_u_tube(const TubeFrame& frame, const Vec3& side, double radius, double leg,
                          double gap);

/// A tube with any closed profile: v along the axis, u through the profile's points (periodic).
NurbsSurface nurbs_extrusion(std::span<const Vec3> profile, const Vec3& way);

/// Bicubic sheet x = u, y = v, z = height(u, v) over a rectangle, with n x n control points (n at
/// least 4), turned and moved afterwards by `place`.
NurbsSurface nurbs_sheet(double width, double depth, std::size_t n,
                         const std::function<Vec3(double x, double y)>& place);

}  // namespace spigolo
