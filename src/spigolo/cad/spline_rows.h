// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/cad/spline_rows.h - smooth curves and strips through given points, as NURBS
#pragma once

#include <array>
#include <span>

#include "spigolo/cad/nurbs_surface.h"

namespace spigolo {

/// A cubic curve through all points in order, smooth to the first derivative, parameter by chord
/// length from 0 to 1. Its slopes are local (that of the parabola through three points), so one bad
/// point disturbs its two neighbors and no more. closed: it comes back to the first point, which is
/// not repeated in `points`. Throws Error for fewer than two points (closed: three), or if all are
/// in one place.
NurbsCurve spline_through(std::span<const Vec3> points, bool closed);

/// Four control points of a cubic across a strip.
using StripPoles = std::array<Vec3, 4>;

/// The surface that is the given cubic across (parameter v in [0, 1]) at each station, and whose
/// four rows of control points run smoothly along (parameter u in [0, 1]) as spline_through does.
/// station receives the u of each one if it is given. Throws as spline_through.
NurbsSurface surface_through(std::span<const StripPoles> strips, bool closed,
                             std::vector<double>* station = nullptr);

}  // namespace spigolo
