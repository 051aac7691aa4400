// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/recognize.h - is a curve straight, or round?
#pragma once

#include <optional>
#include <span>

#include "spigolo/core/geometry.h"

namespace spigolo {

struct LineFit {
  Vec3 place, direction;  // direction unit
  double residual = 0;    // robust rms distance of the places
};

/// Robust least squares line through the places, along the way from the first to the last.
LineFit fit_line(std::span<const Vec3> places, double exact);

struct CircleFit {
  Vec3 center, axis;  // axis unit, sign arbitrary
  double radius = 0;
  double residual = 0;  // robust rms distance of the places

  double distance(const Vec3& p) const;
  Vec3 nearest(const Vec3& p) const;
};

/// Robust least squares circle in space: distances to the circle itself, Gauss-Newton with Cauchy
/// weights from an algebraic start. Nothing for fewer than four places or places along a line.
/// exact: residuals below this are none.
std::optional<CircleFit> fit_circle(std::span<const Vec3> places, double exact);

/// The circle through three points; nothing if they lie on a line.
std::optional<CircleFit> circle_through(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace spigolo
