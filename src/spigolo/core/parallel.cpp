// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/core/parallel.cpp
#include "spigolo/core/parallel.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <mutex>

#ifdef SPIGOLO_TSAN
#include <sanitizer/tsan_interface.h>
#endif

namespace spigolo {
namespace {

// tbb is not built with the thread sanitizer. These tell it what tbb guarantees: what was written
// before a loop is seen by its bodies, and what they wrote is seen after it.
#ifdef SPIGOLO_TSAN
void acquire(char& mark) { __tsan_acquire(&mark); }
void release(char& mark) { __tsan_release(&mark); }
#else
void acquire(char&) {}
void release(char&) {}
#endif

char fork_mark, join_mark;
struct Loop {
  Loop() { release(fork_mark); }
  ~Loop() { acquire(join_mark); }
};
struct Range {
  Range() { acquire(fork_mark); }
  ~Range() { release(join_mark); }
};

// Reports the share done, at most once a percent, one thread at a time.
class Reporter {
 public:
  Reporter(const Job& job, std::string_view stage, std::size_t count)
      : job_(job), stage_(stage), count_(count) {
    if (active()) job_.progress(stage_, 0);
  }
  void advance(std::size_t n) {
    if (!active()) return;
    const std::size_t done = done_.fetch_add(n) + n;
    const std::unique_lock lock(mutex_, std::try_to_lock);
    const int percent = static_cast<int>(100 * done / count_);
    if (!lock.owns_lock() || percent <= percent_) return;
    percent_ = percent;
    job_.progress(stage_, static_cast<double>(done) / static_cast<double>(count_));
  }

 private:
  bool active() const { return job_.progress && !stage_.empty(); }

  const Job& job_;
  std::string_view stage_;
  std::size_t count_;
  std::atomic<std::size_t> done_{0};
  std::mutex mutex_;
  int percent_ = 0;
};

}  // namespace

int thread_count(const Job& job) {
  return job.threads > 0 ? job.threads : tbb::this_task_arena::max_concurrency();
}

void parallel_for(const Job& job, std::string_view stage, std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t, std::size_t)>& body) {
  job.check();
  if (count == 0) return;
  grain = std::max<std::size_t>(grain, 1);
  Reporter reporter(job, stage, count);
  // Ranges start at multiples of the grain: what a body is handed does not depend on the threads.
  const std::size_t chunks = (count + grain - 1) / grain;
  const auto run = [&](std::size_t chunk) {
    job.check();
    const std::size_t begin = chunk * grain, end = std::min(count, begin + grain);
    body(begin, end);
    reporter.advance(end - begin);
  };
  if (thread_count(job) == 1) {
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) run(chunk);
    return;
  }
  // Without this the library caps at the number of cores, and says so on stderr.
  const tbb::global_control allowance(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(thread_count(job)));
  tbb::task_arena arena(thread_count(job));
  const Loop loop;
  arena.execute([&] {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, chunks, 1),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                        const Range ordered;
                        for (std::size_t c = range.begin(); c != range.end(); ++c) run(c);
                      });
  });
}

}  // namespace spigolo
