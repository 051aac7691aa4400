// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/weld.h - points of equal coordinates become one
#pragma once

#include <cstdint>
#include <vector>

#include "spigolo/core/geometry.h"

namespace spigolo {

/// Numbers different positions in the order of their first appearance. Minus zero is zero, and any
/// NaN equals any other.
class Welder {
 public:
  /// The number of the position. Throws MemoryError beyond 2^32 - 2 of them.
  std::uint32_t index(Vec3 p);
  /// Hands the positions over.
  std::vector<Vec3> take();

 private:
  void grow();
  std::size_t slot_of(const Vec3& p) const;

  std::vector<Vec3> points_;
  std::vector<std::uint32_t> slots_;  // open addressing; number of the point or `free`
};

}  // namespace spigolo
