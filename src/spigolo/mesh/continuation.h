// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/continuation.h - where the surface is between its points
#pragma once

#include <array>
#include <span>
#include <utility>

#include "spigolo/mesh/point_cells.h"
#include "spigolo/mesh/surface_points.h"

namespace spigolo {

class Continuation {
 public:
  /// cloud: the positions of all points of the surface, in their order. farthest: [unit] from a
  /// place asked about to the surface. Keeps references to both.
  Continuation(const SurfacePoints& surface, const PointCells& cloud, double farthest)
      : surface_(surface), cloud_(cloud), farthest_(farthest) {}

  /// The sheets of the nearest surface points of about that normal, continued to a place: their
  /// mean where they agree, else no surface. One that errs is outvoted, not followed.
  SurfaceFoot at(const Vec3& place, const Vec3& normal) const;

 private:
  static constexpr std::size_t most = 4;             // sheets that are asked
  using Witness = std::pair<double, std::uint32_t>;  // squared distance, surface point

  std::array<Witness, most> find_witnesses(const Vec3& place, const Vec3& normal) const;
  double weight_of(const Witness& witness) const;
  SurfaceFoot by_sheets(std::span<const Witness> nearest, const Vec3& place,
                        const Vec3& normal) const;
  SurfaceFoot by_arcs(std::span<const Witness> nearest, const Vec3& place,
                      const Vec3& normal) const;
  double arc_height(const Witness& from, const Vec3& place, const Vec3& normal) const;

  const SurfacePoints& surface_;
  const PointCells& cloud_;
  const double farthest_;
};

}  // namespace spigolo
