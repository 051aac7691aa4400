// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/handles.h - tunnels and strands three edges around
#pragma once

#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/mesh/edges.h"

namespace spigolo {

/// Three edges around that are no triangle, with the surface still in one piece when it is cut
/// along them: a tunnel through a wall or a strand between two, thinner than samples can show.
/// Takes away the triangles at its corners, which leaves a hole at either end. triangles: manifold
/// and oriented. Returns how many were found.
std::size_t cut_handles(std::vector<Triangle>& triangles, std::size_t vertices,
                        const Job& job = {});

}  // namespace spigolo
