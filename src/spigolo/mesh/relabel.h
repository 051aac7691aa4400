// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/relabel.h - labels made smooth: no bubbles, no pockets, a manifold between the sides
#pragma once

#include "spigolo/core/job.h"
#include "spigolo/mesh/label.h"

namespace spigolo {

struct RelabelReport {
  std::size_t bubbles = 0;    // parts that were no more than accidents of the labelling
  std::size_t turned = 0;     // single tetrahedra that changed sides for a better surface
  std::size_t untangled = 0;  // places that were not manifold and are
  std::size_t tangled = 0;    // places that still are not
};

/// Changes labels where that makes the surface between the two sides better: first whole parts
/// whose surface mostly runs square to the sheets, then single tetrahedra as long as area and tilt
/// shrink, then around edges and vertices where the surface touches itself. Crease segments stay.
RelabelReport refine_labels(const Delaunay& delaunay, const MeshSamples& samples,
                            const CreaseSides& sides, Labelling& labels, const Job& job = {});

/// The facets between the sides, counterclockwise seen from outside, as vertices of the samples.
/// Those at the helpers of the tetrahedra are left out.
std::vector<Triangle> boundary(const Delaunay& delaunay, const Labelling& labels);

}  // namespace spigolo
