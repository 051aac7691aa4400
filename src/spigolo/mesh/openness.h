// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/openness.h - does a facet between tetrahedra look like surface or like empty space?
#pragma once

#include "spigolo/mesh/delaunay.h"
#include "spigolo/mesh/samples.h"
#include "spigolo/mesh/sides.h"

namespace spigolo {

/// How much a facet looks like empty space rather than surface: 0 along the sheets of its corners,
/// 1 square to them; plus a quarter for each step its longest edge is longer than one.
class Openness {
 public:
  Openness(const Delaunay& delaunay, const MeshSamples& samples, const CreaseSides& sides)
      : delaunay_(delaunay), samples_(samples), sides_(sides) {}

  double of(std::uint32_t tet, std::size_t facet) const;

  /// [rad] between the facet and the sheets of its corners, the largest; pi / 2 where it is a line.
  double tilt(const Triangle& corners) const;
  /// Longest edge, in edge lengths aimed at around it.
  double length(const Triangle& corners) const;

 private:
  const Delaunay& delaunay_;
  const MeshSamples& samples_;
  const CreaseSides& sides_;
};

}  // namespace spigolo
