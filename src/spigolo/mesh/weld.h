// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/weld.h - creases that run over each other become one
#pragma once

#include "spigolo/mesh/samples.h"

namespace spigolo {

/// Where two curves of a network cover the same stretch, or one runs past the corner in which
/// another ends, their samples stand closer together than tetrahedra can tell apart. Crease
/// vertices inside of a curve that are within .3 steps of another one become that one; segments
/// that pass a vertex by less than .1 steps are cut there; what is then there twice goes. samples:
/// of creases only.
void weld_creases(MeshSamples& samples);

}  // namespace spigolo
