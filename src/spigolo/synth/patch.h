// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/patch.h - exact smooth pieces of surface: samples uniform by area, nearest points
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "spigolo/core/random.h"
#include "spigolo/synth/curve.h"

namespace spigolo {

/// A smooth piece of surface with its border.
struct Patch {
  double area = 0;
  std::function<Vec3(Random& random)> sample;  // uniform by area
  std::function<Vec3(const Vec3& p)> nearest;  // the point of the patch nearest to p
};

struct Vec2 {
  double x = 0, y = 0;
};

/// A closed border in a plane: a polygon of at least 3 corners, or a circle when radius > 0.
struct Loop {
  std::vector<Vec2> corners;
  Vec2 center;
  double radius = 0;
};

/// The part of the frame's x, y plane inside `outer` and outside all holes; the holes lie inside
/// `outer` and do not meet.
Patch planar_patch(const Frame& frame, const Loop& outer, const std::vector<Loop>& holes = {});

/// Flat polygon in space; the corners lie in one plane and run counterclockwise from outside.
Patch polygon_patch(const std::vector<Vec3>& corners, const std::vector<Loop>& holes = {});

/// The plane of a polygon: origin at corner 0, z along the outer normal.
Frame polygon_frame(const std::vector<Vec3>& corners);

/// Part of a cylinder about the frame's z axis: z in [0, height], azimuth in [0, sector] from the x
/// axis; sector 2 pi is the whole way round.
Patch cylinder_patch(const Frame& frame, double radius, double height, double sector = 2 * pi);

/// A straight meridian from a to b (x: distance from the axis, y: height) turned about the frame's
/// z axis: cylinder, cone, disk, ring.
Patch turned_segment(const Frame& frame, const Vec2& a, const Vec2& b);

/// A circular meridian: `center` (x: distance from the axis), radius, polar angle from `from` to
/// `to` > `from` (0 points away from the axis, pi/2 up), turned about the frame's z axis: sphere,
/// torus and parts of them. It must not cross the axis.
struct MeridianArc {
  Vec2 center;
  double radius = 1, from = 0, to = 2 * pi;
};
Patch turned_arc(const Frame& frame, const MeridianArc& arc);

/// The eighth of a sphere about the frame's origin where all three coordinates are positive.
Patch octant_patch(const Frame& frame, double radius);

/// A part of a whole patch, cut out by curves.
struct Trim {
  double area = 0;                           // of what is kept
  std::function<bool(const Vec3& p)> keeps;  // for points of the whole patch
  std::vector<Curve> border;                 // of what is kept
};
/// The nearest point of the whole patch must be the only local minimum of a distance on it.
Patch trimmed_patch(const Patch& whole, const Trim& trim);

/// The surface of straight lines from a(u) to b(u), u in [0, 1]. element(u, v): its exact area per
/// du dv; largest: an upper bound of it.
struct Ruled {
  std::function<Vec3(double u)> a, b;
  std::function<double(double u, double v)> element;
  double largest = 0;
  int seeds = 32;  // steps in u fine enough to tell the minima of a distance apart
};
Patch ruled_patch(const Ruled& ruled);

}  // namespace spigolo
