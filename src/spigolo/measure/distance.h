// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/measure/distance.h - distances between clouds, and of a cloud to a mesh
#pragma once

#include <span>
#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/core/triangle_mesh.h"

namespace spigolo {

/// Of absolute values; distances that are not finite are left out.
struct DistanceStats {
  double mean = 0;
  double rms = 0;
  double p95 = 0;  // 95 of 100 are not larger (nearest rank)
  double max = 0;
  double signed_mean = 0;  // with the signs of the distances, if they have any
  std::size_t count = 0;
  std::size_t skipped = 0;  // not finite
};
DistanceStats summarize(std::span<const double> distances);

/// Share of the finite distances whose absolute value is at most `tolerance`; 0 if there are none.
double share_within(std::span<const double> distances, double tolerance);

/// Distance of every point to its nearest point of `to`; NaN for points that are not finite. Throws
/// NoResultError if `to` has no finite point.
std::vector<double> distances_to_points(std::span<const Vec3> points, std::span<const Vec3> to,
                                        const Job& job = {});

/// Exact distance of every point to the nearest place of the mesh; NaN for points that are not
/// finite. with_sign: positive outside, negative inside (or in front of and behind an open mesh),
/// by pseudo-normals. Throws NoResultError if the mesh has no triangle with area.
std::vector<double> distances_to_mesh(std::span<const Vec3> points, const TriangleMesh& mesh,
                                      bool with_sign, const Job& job = {});

/// Exact distance of every point to the nearest of the segments; NaN for points that are not
/// finite. Throws NoResultError if no segment has finite ends.
std::vector<double> distances_to_segments(std::span<const Vec3> points,
                                          std::span<const Vec3> vertices, const Segments& segments,
                                          const Job& job = {});

struct Comparison {
  DistanceStats a_to_b, b_to_a;
};

/// Both ways.
Comparison compare(std::span<const Vec3> a, std::span<const Vec3> b, const Job& job = {});

/// The points to the mesh, with sign; the vertices of the mesh's triangles to the points.
Comparison compare(std::span<const Vec3> a, const TriangleMesh& b, const Job& job = {});

}  // namespace spigolo
