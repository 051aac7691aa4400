// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/widen.h - acute corners: a ball that would fold the collar gets larger around them
#pragma once

#include "spigolo/blend/strand.h"

namespace spigolo {

/// Under a tube that leans over the cloud the ball turns sharply, and the collar behind it, nearer
/// to the turn's center by the radius, more sharply still, until it folds. What helps is a ball
/// that is larger on both sides of the most acute place than there, so that it turns in a wider
/// bend: its radius is R + widening (1 - cos(angle) / cos(least angle)).
double widened(double radius, double widening, double angle, double least_angle);

/// Finds the widening, from one rolling to the next.
class Widening {
 public:
  /// roundness: the collar bends along the loop no more sharply than with this radius.
  explicit Widening(double roundness) : roundness_(roundness) {}

  /// [length] for the next rolling.
  double value() const { return value_; }
  /// Looks at the balls that have rolled with that value; false if there is no better one: then the
  /// collar is round enough, or gets no rounder.
  bool improve(const BorderLoop& loop);

 private:
  double roundness_;
  double value_ = 0, best_ = 0, least_turn_ = infinity;
  bool settled_ = false;
};

}  // namespace spigolo
