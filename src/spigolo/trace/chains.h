// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/chains.h - samples of creases linked to chains, each along one crease
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "spigolo/trace/crease_samples.h"

namespace spigolo {

/// Places along one crease, in order. Lengths in spacings.
struct Chain {
  std::vector<Vec3> places;
  bool closed = false;
  bool bridged = false;  // has a stretch without samples that was filled in

  double length() const;
};

/// Thins the samples to about one a spacing, the ones with most weight first, and links each to the
/// next on either side: pairs in the order of their distance and bend, each end once. A step turns
/// no sharper than a circle of three spacings would. Chains of a single sample are left out.
std::vector<Chain> link_samples(std::span<const CreaseSample> samples, double scatter);

}  // namespace spigolo
