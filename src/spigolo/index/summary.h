// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/index/summary.h - what a raw cloud is, before anything is done with it
#pragma once

#include <span>

#include "spigolo/core/geometry.h"
#include "spigolo/core/job.h"

namespace spigolo {

struct CloudSummary {
  std::size_t points = 0;      // as given
  std::size_t distinct = 0;    // finite points at different places
  std::size_t duplicates = 0;  // repeats of a place
  std::size_t non_finite = 0;  // points with a NaN or infinite coordinate
  Box bounds;                  // of the finite points; empty if there are none
  double spacing = 0;          // in the units of the input; 0 if unknown
  double noise = 0;            // standard deviation across the surface, in spacings
};

/// Never throws for odd clouds: what cannot be told is 0.
CloudSummary summarize(std::span<const Vec3> points, const Job& job = {});

}  // namespace spigolo
