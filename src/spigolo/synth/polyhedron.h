// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/polyhedron.h - shapes with flat faces, features found from the faces themselves
#pragma once

#include <string>
#include <vector>

#include "spigolo/synth/shape.h"

namespace spigolo {

/// Flat faces over shared vertices, each face counterclockwise from outside.
struct Polyhedron {
  std::vector<Vec3> vertices;
  std::vector<std::vector<std::size_t>> faces;
};

/// Patch i is face i. An edge of two faces is a crease with their angle (none if they lie in one
/// plane), an edge of one face a border; a vertex where three or more creases end is a corner.
Shape polyhedron_shape(const std::string& name, const Polyhedron& polyhedron);

/// A counterclockwise polygon in the x, y plane lifted from z0 to z1; face 0 is the bottom, 1 the
/// top.
Polyhedron prism(const std::vector<Vec2>& polygon, double z0, double z1);

/// A box; face 0 is the bottom, 1 the top.
Polyhedron box_polyhedron(const Vec3& min, const Vec3& max);

/// A box about the origin with a round hole of that radius right through it along z.
Shape drilled_box(const std::string& name, const Vec3& size, double radius);

/// Radius of the smallest ball that holds all points (at most a few hundred).
double bounding_radius(const std::vector<Vec3>& points);

}  // namespace spigolo
