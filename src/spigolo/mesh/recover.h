// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/recover.h - crease segments that the surface passes by become edges of it
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "spigolo/core/geometry.h"
#include "spigolo/core/job.h"
#include "spigolo/mesh/check.h"
#include "spigolo/mesh/edges.h"

namespace spigolo {

struct RecoverReport {
  std::size_t flipped = 0;   // edges
  std::size_t inserted = 0;  // crease vertices
};

/// Of each segment that is no edge, ends that are no vertices of the surface are put into it, in
/// the middle of an edge or of a triangle beside the crease, and edges that cross the segment are
/// flipped. Nothing is done that would run into the surface or make it less than manifold, so some
/// may stay lost.
RecoverReport recover_creases(std::vector<Triangle>& triangles, const std::vector<Vec3>& points,
                              std::span<const VertexPair> creases, const Job& job = {});

}  // namespace spigolo
