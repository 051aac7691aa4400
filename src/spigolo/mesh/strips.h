// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/strips.h - sheets so narrow that no point of the cloud shows which way they face
#pragma once

#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/mesh/samples.h"

namespace spigolo {

/// The side of a step, the edge of a thin plate: where two creases run along each other, each with
/// a sheet on one side only, the sheet between them is the one that spans them. One foot for each
/// crease segment, in the middle between the creases; segments longer than the strip is wide are
/// halved. samples: creases only.
std::vector<SurfaceFoot> find_strips(const SurfacePoints& surface, MeshSamples& samples,
                                     const Job& job = {});

}  // namespace spigolo
