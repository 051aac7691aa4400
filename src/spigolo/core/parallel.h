// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/core/parallel.h - the only door to threads
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

#include "spigolo/core/job.h"

namespace spigolo {

/// Calls body(begin, end) for disjoint ranges that cover [0, count), in any order, on job.threads
/// threads. A body writes only what belongs to its own range, so the result is the same for any
/// number of threads. Reports progress as `stage` (no report if it is empty) and throws Cancelled
/// between two ranges when the job is stopped. The first exception of a body is passed on.
/// grain: the longest range handed out; at least 1.
void parallel_for(const Job& job, std::string_view stage, std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t begin, std::size_t end)>& body);

/// The number of threads a job will use.
int thread_count(const Job& job);

}  // namespace spigolo
