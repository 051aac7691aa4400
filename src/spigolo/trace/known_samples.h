// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/known_samples.h - what is known of creases where a march starts, and where it ends
#pragma once

#include <span>
#include <vector>

#include "spigolo/trace/place_grid.h"
#include "spigolo/trace/survey.h"

namespace spigolo {

/// Views the samples, which must outlive it. Lengths in spacings.
class KnownSamples {
 public:
  explicit KnownSamples(std::span<const CreaseSample> samples);

  double angle_at(const Vec3& place) const;           // [rad] deviation from flat round there
  std::int8_t convexity_at(const Vec3& place) const;  // as the samples round there say
  /// Whether a march has come to one of the samples, away from where it started.
  bool knows(const CreaseSample& seen, const Vec3& from) const;

 private:
  std::span<const CreaseSample> samples_;
  PlaceGrid grid_;
};

/// What a march from an end sees, up to places that are known.
std::vector<CreaseSample> march_from(const Survey& survey, const ChainEnd& end,
                                     const KnownSamples& known);

}  // namespace spigolo
