// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/meter.cpp - clocks and /proc of Linux
#include "meter.h"

#include <sys/resource.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <algorithm>
#include <chrono>
#include <ctime>
#include <fstream>
#include <string>

namespace spigolo::bench {
namespace {

double clock_seconds(clockid_t clock) {
  timespec t;
  clock_gettime(clock, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double seconds_of(const timeval& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

// A line of /proc/self/status in bytes.
std::size_t status_bytes(const std::string& name) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::size_t kilobytes = 0;
    if (word == name && status >> kilobytes) return kilobytes * 1024;
  }
  return 0;
}

// What was freed goes back to the system, or it would hide what is taken next.
void return_freed() {
#ifdef __GLIBC__
  malloc_trim(0);
#endif
}

// From here on the highest resident memory is counted anew.
void reset_peak() { std::ofstream("/proc/self/clear_refs") << 5; }

}  // namespace

double cpu_seconds() { return clock_seconds(CLOCK_PROCESS_CPUTIME_ID); }

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double children_seconds() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  return seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
}

Meter::Meter() {
  return_freed();
  reset_peak();
  resident_ = status_bytes("VmRSS:");
  own_ = clock_seconds(CLOCK_THREAD_CPUTIME_ID);
  cpu_ = cpu_seconds();
  wall_ = wall_seconds();
}

double Meter::wall() const { return wall_seconds() - wall_; }
double Meter::cpu() const { return cpu_seconds() - cpu_; }

double Meter::alone(int threads) const {
  const double own = clock_seconds(CLOCK_THREAD_CPUTIME_ID) - own_;
  if (threads < 2) return own;
  const double each_other = (cpu() - own) / (threads - 1);
  return std::max(0.0, own - each_other);
}

std::size_t Meter::peak_bytes() const {
  const std::size_t peak = status_bytes("VmHWM:");
  return peak > resident_ ? peak - resident_ : 0;
}

}  // namespace spigolo::bench
