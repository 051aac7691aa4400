// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// examples/02_progress_and_cancel.cpp - shows how far the work is, and gives up after some seconds
//
// usage: example_02_progress_and_cancel [SECONDS]
#include <spigolo/spigolo.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <stop_token>
#include <vector>

namespace {

// A curved dish: no edge anywhere, but a border all round.
std::vector<spigolo::Vec3> dish(int n) {
  std::vector<spigolo::Vec3> points;
  for (int i = -n; i <= n; ++i)
    for (int j = -n; j <= n; ++j) points.push_back({1.0 * i, 1.0 * j, 0.02 * (i * i + j * j)});
  return points;
}

}  // namespace

int main(int argc, char** argv) {
  using Clock = std::chrono::steady_clock;
  const double limit = argc > 1 ? std::atof(argv[1]) : 60;
  const auto start = Clock::now();

  std::stop_source stop;  // anyone may ask it to stop: another thread, a signal handler's flag
  spigolo::Job job;
  job.threads = 0;  // all there are; the result is the same for any number
  job.stop = stop.get_token();
  job.progress = [&](std::string_view stage, double share) {  // never by two threads at once
    std::fprintf(stderr, "\r%-10.*s %3.0f %%", static_cast<int>(stage.size()), stage.data(),
                 100 * share);
    if (std::chrono::duration<double>(Clock::now() - start).count() > limit) stop.request_stop();
  };

  try {
    const spigolo::Detection found = spigolo::detect(dish(75), {}, job);
    const auto counts = found.features.counts();  // by the numbers of PointKind
    std::printf("\ndone: %zu edge points, %zu border points\n", counts[1], counts[4]);
  } catch (const spigolo::Cancelled&) {  // nothing is left behind
    std::printf("\ncancelled after %g s\n", limit);
    return 130;
  }
  return 0;
}
