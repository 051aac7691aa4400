// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/core/random.h - seeded random numbers, the same bits on every platform
#pragma once

#include <cstdint>

#include "spigolo/core/geometry.h"

namespace spigolo {

/// xoshiro256** (Blackman, Vigna 2018), seeded through splitmix64. The standard library's
/// distributions differ from vendor to vendor; these do not.
class Random {
 public:
  explicit Random(std::uint64_t seed);

  std::uint64_t bits();  // 64 random bits
  double uniform();      // in [0, 1)
  double uniform(double a, double b) { return a + (b - a) * uniform(); }
  std::uint64_t below(std::uint64_t n);  // in [0, n), n >= 1, without bias
  double normal();                       // mean 0, standard deviation 1 (polar method)
  Vec3 in_ball();                        // uniform in the unit ball
  Vec3 on_sphere();                      // uniform on the unit sphere

 private:
  std::uint64_t state_[4];
};

}  // namespace spigolo
