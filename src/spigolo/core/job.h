// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/core/job.h - how a long computation is run: threads, progress, cancelling
#pragma once

#include <functional>
#include <stop_token>
#include <string_view>

#include "spigolo/core/error.h"

namespace spigolo {

/// Called now and then with the name of the running stage and its share done in [0, 1]; never by
/// two threads at once. It must not throw.
using ProgressCallback = std::function<void(std::string_view stage, double share)>;

/// Handed to everything that can take longer than a second. The result of a computation never
/// depends on it.
struct Job {
  int threads = 0;            // 0: as many as the machine has
  ProgressCallback progress;  // may be empty
  std::stop_token stop;       // a triggered one ends the computation with Cancelled

  void check() const {
    if (stop.stop_requested()) throw Cancelled();
  }
};

}  // namespace spigolo
