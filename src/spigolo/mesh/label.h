// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/label.h - which tetrahedra are inside: the surface is where the label changes
#pragma once

#include <cstdint>
#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/mesh/delaunay.h"
#include "spigolo/mesh/samples.h"
#include "spigolo/mesh/sides.h"

namespace spigolo {

/// What a sample or a crease segment says about one tetrahedron.
struct Belief {
  std::uint32_t tetrahedron = 0;
  std::uint8_t inside = 0;
};

struct Labelling {
  std::vector<std::uint8_t> inside;  // per slot of a tetrahedron
  std::vector<Belief> beliefs;       // as most samples of a part have it; labels may differ
  std::size_t contradictions = 0;    // statements about the surface that could not all be true
};

/// Vertex i of the samples is vertex i + Delaunay::helpers. Statements that two tetrahedra are on
/// the same side or on different sides of the surface are taken one by one, the surest first, and
/// left out where they contradict those before: on either side of a sheet vertex, along its normal,
/// it is different; next to a neighbor on the sheet it is the same; so it is in the two spaces
/// beside a crease; across facets it is the same, the most open first.
Labelling label_tetrahedra(const Delaunay& delaunay, const MeshSamples& samples,
                           const CreaseSides& sides, const Job& job = {});

}  // namespace spigolo
