// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mls/quadratic.h - a quadratic height field over a plane, its normal and its curvatures
#pragma once

#include <array>
#include <span>
#include <vector>

#include "spigolo/core/geometry.h"

namespace spigolo {

/// Orthonormal frame with its own unit of length.
struct TangentFrame {
  Vec3 origin;
  Vec3 u, v, n;
  double unit = 1;
};

/// n: unit; u and v follow from it.
TangentFrame tangent_frame(const Vec3& origin, const Vec3& n, double unit);

/// g = a0 + a1 u + a2 v + a3 uu + a4 uv + a5 vv, all in units of the frame.
struct Quadratic {
  std::array<double, 6> a{};
};

/// Weighted least squares of the points' heights over the frame; weight: one per point, the largest
/// about 1. Second-order terms the points do not determine (all on a line or two, fewer than six
/// points) stay near zero: a ridge of 1e-10 of the weights draws them there.
Quadratic fit_quadratic(const TangentFrame& frame, std::span<const Vec3> points,
                        std::span<const double> weight);

/// Unit normal over the frame's origin, on the side of n.
Vec3 normal_of(const Quadratic& g, const TangentFrame& frame);

/// Principal curvatures over the frame's origin, the larger one first, positive where the surface
/// bends towards n: eigenvalues of the shape operator (do Carmo 1976, §3.3). In 1 / length.
std::array<double, 2> curvatures_of(const Quadratic& g, const TangentFrame& frame);

}  // namespace spigolo
