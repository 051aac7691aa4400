// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/caps.h - holes closed by surfaces that continue what is around them
#pragma once

#include <cstddef>
#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/core/triangle_mesh.h"

namespace spigolo {

struct CapOptions {
  double step = 1;  // [unit] edge length of the new triangles
  double largest =
      1;  // [unit] across, for holes with edges of a step; wider ones stay. Where edges
          // along a hole are longer it may be wider as much. Infinite: no width is too much
};

struct CapReport {
  std::size_t smooth = 0;    // holes closed by a cap that leaves the border along the sheets
  std::size_t taut = 0;      // by one like a soap film: the sheets around are flat and end steeply
  std::size_t left = 0;      // holes left open, since any cap would run into the mesh or ...
  std::size_t too_long = 0;  // ... more than `longest_loop` edges go around
};

/// Closes border loops by caps of even triangles. A cap bends as little as it can while it leaves
/// the border in the direction of the sheets there; where these would have to turn far and do not
/// bend (a box without its lid) the cap is the film spanned by the border, with an edge along it.
/// Loops of more than `longest_loop` edges stay.
CapReport close_smoothly(TriangleMesh& mesh, const CapOptions& options, const Job& job = {});

}  // namespace spigolo
