// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/loops.h - from the marked starts to the borders of the collar on both sides
#pragma once

#include <string>
#include <vector>

#include "spigolo/blend/border.h"
#include "spigolo/blend/normals.h"
#include "spigolo/blend/setback.h"

namespace spigolo {

/// The starts of the options; if there are none, the one border that lies outside the cloud and
/// from which the face meets it. Throws NoResultError if that says nothing, or if a start lies
/// inside the cloud.
std::vector<BlendStart> choose_starts(const NurbsFace& face, const CloudSide& cloud,
                                      const CloudNormals& normals, const BlendOptions& options,
                                      const Job& job);

/// One start with all that was found from it.
struct TracedStart {
  Isolines isolines;
  BorderLoop loop;
  std::size_t missed = 0;   // lines that do not meet the cloud
  std::size_t patched = 0;  // betas put between their neighbors
};

/// Intersections of all starts and the side that stays.
std::vector<TracedStart> trace_starts(const NurbsFace& face, const CloudSide& cloud,
                                      const std::vector<BlendStart>& starts,
                                      const BlendOptions& options, const Job& job);

/// Setbacks, alphas and betas of every start, with more lines where these are far apart. A radius
/// that the user has not chosen becomes smaller if the cloud has no room for the collar. Throws
/// NoResultError where there is no room, or where two collars overlap.
void trace_borders(const CloudSide& cloud, Setbacks& setbacks, std::vector<TracedStart>& traced,
                   const Job& job);

}  // namespace spigolo
