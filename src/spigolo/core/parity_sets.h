// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/core/parity_sets.h - disjoint sets whose members are of one kind or the opposite kind
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace spigolo {

/// Each element knows whether it is of the same kind as the root of its set (parity 0) or of the
/// opposite one (1).
class ParitySets {
 public:
  explicit ParitySets(std::size_t n) : parent_(n), parity_(n, 0) {
    std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
  }

  struct Root {
    std::uint32_t set;
    std::uint8_t parity;
  };

  Root find(std::uint32_t x) {
    std::uint32_t root = x;
    std::uint8_t parity = 0;
    while (parent_[root] != root) parity ^= parity_[root], root = parent_[root];
    const Root found{root, parity};
    while (parent_[x] != root && x != root) {  // paths become short
      const std::uint32_t above = parent_[x];
      const std::uint8_t here = parity_[x];
      parent_[x] = root;
      parity_[x] = parity;
      parity ^= here;
      x = above;
    }
    return found;
  }

  /// Says that a and b are of the same (0) or of opposite kinds (1). False if that contradicts what
  /// was said before; then nothing changes.
  bool join(std::uint32_t a, std::uint32_t b, std::uint8_t differ = 0) {
    const Root ra = find(a), rb = find(b);
    if (ra.set == rb.set) return (ra.parity ^ rb.parity) == differ;
    const auto [low, high] = std::minmax(ra.set, rb.set);
    parent_[high] = low;  // the smaller number is the root: no tie to break
    parity_[high] = ra.parity ^ rb.parity ^ differ;
    return true;
  }

  /// Makes every path one step long: from here on until the next join, root() tells what find()
  /// does, to any number of threads at once.
  void flatten() {
    for (std::size_t x = 0; x < parent_.size(); ++x) {  // what is above x is smaller: flat already
      const std::uint32_t above = parent_[x];
      if (above == x) continue;
      parity_[x] ^= parity_[above];
      parent_[x] = parent_[above];
    }
  }

  Root root(std::uint32_t x) const { return {parent_[x], parity_[x]}; }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint8_t> parity_;
};

}  // namespace spigolo
