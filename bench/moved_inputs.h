// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/moved_inputs.h - the same cloud in another order, place, size and direction
#pragma once

#include <vector>

#include "report.h"
#include "spigolo/synth/synth.h"

namespace spigolo::bench {

/// The clouds of the section on determinism.
std::vector<SynthOptions> moved_inputs();

/// What the input's order, place, size and direction change once they are undone.
void moved_inputs_tables(Report& report);

}  // namespace spigolo::bench
