// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/gradient.h - a factor that grows evenly (exponentially) across a shape
#pragma once

#include "spigolo/core/geometry.h"

namespace spigolo {

/// 1 / sqrt(ratio) at one end of a side of a box, 1 in its middle, sqrt(ratio) at the other end.
class Gradient {
 public:
  /// The same everywhere.
  Gradient() = default;
  /// ratio >= 1; rank 0: along the longest side of the box, 1: the second longest, 2: the shortest.
  Gradient(const Box& box, std::size_t rank, double ratio);

  double at(const Vec3& p) const;
  double largest() const { return std::exp(rate_ / 2); }
  bool even() const { return rate_ == 0; }

 private:
  std::size_t axis_ = 0;
  double from_ = 0, length_ = 1;
  double rate_ = 0;  // logarithm of the ratio
};

}  // namespace spigolo
