// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/spoil.h - noise, repeated points, outliers (inside synth only)
#pragma once

#include "spigolo/synth/synth.h"

namespace spigolo {

/// Moves the samples by options.noise and noise_percent and sets truth_x, truth_y, truth_z.
void add_noise(SynthCloud& made, const SynthOptions& options);

/// Appends copies of random samples, with all they carry.
void add_duplicates(SynthCloud& made, const SynthOptions& options);

/// Appends points anywhere around the shape; `samples`: how many the share is of.
void add_outliers(SynthCloud& made, const SynthOptions& options, std::size_t samples);

}  // namespace spigolo
