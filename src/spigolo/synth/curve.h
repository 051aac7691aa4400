// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/curve.h - exact curves: where they run and which of their points is nearest
#pragma once

#include <functional>

#include "spigolo/core/geometry.h"

namespace spigolo {

/// Right-handed orthonormal axes at a place.
struct Frame {
  Vec3 origin;
  Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

  Vec3 world(double a, double b, double c) const { return origin + a * x + b * y + c * z; }
  Vec3 local(const Vec3& p) const {
    const Vec3 d = p - origin;
    return {dot(d, x), dot(d, y), dot(d, z)};
  }
};

/// A frame whose z axis is `axis` (any length but 0); x and y are some perpendicular directions.
Frame frame_along(const Vec3& origin, const Vec3& axis);

/// A curve over the parameter range [0, 1].
struct Curve {
  std::function<Vec3(double t)> at;
  std::function<double(const Vec3& p)> nearest;  // parameter of the curve point nearest to p
  bool closed = false;
};

/// Straight from a to b.
Curve segment(const Vec3& a, const Vec3& b);

/// Full circle about the frame's origin in its x, y plane, starting on the x axis.
Curve circle(const Frame& frame, double radius);

/// Any smooth curve. The nearest point is searched from `seeds` equal steps of the parameter, which
/// must be fine enough that no two minima of a distance fall into neighboring ones.
Curve parametric(std::function<Vec3(double t)> at, bool closed, int seeds);

/// The point of the curve nearest to p.
inline Vec3 nearest_point(const Curve& curve, const Vec3& p) { return curve.at(curve.nearest(p)); }

}  // namespace spigolo
