// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/recut.h - doubtful places labelled anew, all at once
#pragma once

#include <cstddef>

#include "spigolo/core/job.h"
#include "spigolo/mesh/label.h"

namespace spigolo {

/// Around facets of the surface that are steep against their sheets, and where tetrahedra are not
/// as the samples believe, the labels are chosen anew: of all labels there, with those farther away
/// as they are, the ones whose surface costs least by area and tilt and contradicts fewest beliefs.
/// Returns how many tetrahedra changed sides.
std::size_t recut_labels(const Delaunay& delaunay, const MeshSamples& samples,
                         const CreaseSides& sides, Labelling& labels, const Job& job = {});

}  // namespace spigolo
