// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/meter.h - what a piece of work costs: time on the wall, of all threads and of one, memory
#pragma once

#include <cstddef>

namespace spigolo::bench {

double cpu_seconds();  // of all threads
double wall_seconds();
double children_seconds();  // CPU of all programs that were run and have ended

/// What was used since the meter was made.
class Meter {
 public:
  Meter();

  double wall() const;
  double cpu() const;
  /// CPU seconds in which the calling thread was the only one at work, if the others share the
  /// work of the parallel parts evenly with it: what it used more than each of them.
  double alone(int threads) const;
  /// Bytes by which resident memory was higher, at its highest; 0 where the system does not say.
  std::size_t peak_bytes() const;

 private:
  double wall_, cpu_, own_;
  std::size_t resident_;
};

}  // namespace spigolo::bench
