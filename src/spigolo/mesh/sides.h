// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/sides.h - the sheets beside a crease, as the vertices near it show them
#pragma once

#include <array>
#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/mesh/samples.h"

namespace spigolo {

inline constexpr std::size_t most_sides = 4;

/// Normals of the sheets that meet at a crease vertex.
struct SideNormals {
  std::array<Vec3, most_sides> normal;  // unit, signs arbitrary
  std::size_t count = 0;
};

/// The two spaces beside a crease segment: directions from its middle, perpendicular to it, into
/// the middle of one and of the other; and of each sheet the sample that showed it.
struct SegmentSides {
  bool known = false;
  std::array<Vec3, 2> into;                 // unit, into the first and the second space
  std::array<std::uint32_t, 2> shown_by{};  // a sheet vertex of each sheet
  std::array<Vec3, 2> along;                // unit, into each sheet
};

struct CreaseSides {
  std::vector<SideNormals> of_vertex;    // per crease vertex; of tips none
  std::vector<SegmentSides> of_segment;  // per segment
};

/// surface: its points show the sheets, too, those near creases that are no samples.
CreaseSides find_crease_sides(const MeshSamples& samples, const SurfacePoints& surface,
                              const Job& job = {});

}  // namespace spigolo
