// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/truth.h - what is true of every sample (inside synth only)
#pragma once

#include "spigolo/synth/synth.h"

namespace spigolo {

/// h of each sample's place, if it is not the same everywhere.
using LocalSpacing = std::vector<double>;

/// Sets truth_feature, truth_edge_distance and truth_kind of the noise-free samples made.exact, and
/// truth_spacing unless `local` is empty. half_seen: a crease of which one side has no samples
/// nearby is a border.
void add_truth(SynthCloud& made, const LocalSpacing& local, bool half_seen, const Job& job);

}  // namespace spigolo
