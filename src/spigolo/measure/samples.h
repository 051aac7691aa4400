// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/measure/samples.h - places of a mesh or of lines between their vertices, close enough to
// measure distances from
#pragma once

#include <span>
#include <vector>

#include "spigolo/core/triangle_mesh.h"

namespace spigolo {

/// Places inside every triangle with a side longer than step, on a grid that cuts each side into
/// pieces of at most step; vertices are not among them, places on shared sides come once for each
/// triangle. Triangles with a vertex that is not finite are left out. step > 0, same unit.
std::vector<Vec3> places_between(const TriangleMesh& mesh, double step);

/// Places that cut every longer segment into pieces of at most step, without its ends.
std::vector<Vec3> places_between(std::span<const Vec3> points, const Segments& segments,
                                 double step);

double area_of(const TriangleMesh& mesh);
double length_of(std::span<const Vec3> points, const Segments& segments);

}  // namespace spigolo
