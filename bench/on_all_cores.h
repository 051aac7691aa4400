// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/on_all_cores.h - the rows of a table at once, where no time is measured
#pragma once

#include <iterator>
#include <vector>

#include "spigolo/core/parallel.h"

namespace spigolo::bench {

/// f(item) of every item, in the order of the items.
template <class Items, class F>
auto on_all_cores(const Items& items, F f) {
  std::vector<decltype(f(*std::begin(items)))> results(std::size(items));
  parallel_for({}, "", results.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      results[i] = f(*(std::begin(items) + std::ptrdiff_t(i)));
  });
  return results;
}

}  // namespace spigolo::bench
