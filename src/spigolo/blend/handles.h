// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/handles.h - how the cubics of the collar leave alpha and beta
#pragma once

#include <utility>

#include "spigolo/blend/strand.h"

namespace spigolo {

/// Where the centers of the balls of a loop run.
class CenterCurve {
 public:
  explicit CenterCurve(const BorderLoop& loop);

  const Vec3& at(std::size_t i) const { return points_[i]; }
  /// The first strands at least `reach` before and behind strand i; i itself where there is none.
  std::pair<std::size_t, std::size_t> around(std::size_t i, double reach) const;

 private:
  std::size_t beyond(std::size_t i, double reach, bool forward) const;

  std::vector<Vec3> points_;
  bool closed_;
};

/// Sets the handles of all strands whose balls are known: across the way of the ball, as long as
/// those of an arc with its radius.
void point_across(BorderLoop& loop);

/// Where an edge of the cloud runs into the collar, the handles of the betas make a corner that no
/// MLS surface can follow; it becomes as round as the cloud's own edges do by that surface.
void round_handles(double smoothing, BorderLoop& loop);

/// Sets the handles of a strand without a ball: towards X, as long as those of an arc that touches
/// both sides at alpha and beta.
void point_to_crossing(Strand& strand);

}  // namespace spigolo
