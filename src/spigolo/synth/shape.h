// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/shape.h - a surface known exactly: smooth patches, creases, corners, tips, borders
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "spigolo/synth/patch.h"

namespace spigolo {

/// A curve in which two smooth patches meet at an angle.
struct ExactCrease {
  Curve curve;
  std::function<double(double t)> deviation;  // [rad] from flat, in (0, pi): pi - interior angle
  int convex = 1;                             // 1 convex, -1 concave
};

struct Corner {
  Vec3 position;
  int valence = 3;  // how many creases end here
};

/// A piecewise smooth surface with its exact features.
struct Shape {
  std::string name{};
  std::vector<Patch> patches{};
  std::vector<ExactCrease> creases{};
  std::vector<Corner> corners{};
  std::vector<Vec3> tips{};      // of cones: sharp points on no crease
  std::vector<Curve> borders{};  // where an open surface ends; never features
  double radius = 0;             // what noise in percent is relative to: the bounding sphere's
};

double area(const Shape& shape);

/// Exact distance to the surface.
double surface_distance(const Shape& shape, const Vec3& p);

/// The nearest point of the nearest crease.
struct CreaseFoot {
  std::size_t crease = 0;
  Vec3 point;
  double distance = infinity;
  double deviation = 0;  // [rad]
  int convex = 0;        // 0 if the shape has no crease
};
CreaseFoot nearest_crease(const Shape& shape, const Vec3& p);

/// Exact distance to the nearest sharp place, crease or tip; infinite if there is none.
double edge_distance(const Shape& shape, const Vec3& p);
double corner_distance(const Shape& shape, const Vec3& p);
double tip_distance(const Shape& shape, const Vec3& p);
double border_distance(const Shape& shape, const Vec3& p);

/// A deviation that is the same all along a crease.
std::function<double(double)> constant(double deviation);

}  // namespace spigolo
