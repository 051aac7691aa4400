// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/interrupt.h - Ctrl-C and kill as a stop token
#pragma once

#include <csignal>
#include <stop_token>

namespace spigolo {

inline constexpr int status_cancelled = 130;

/// From here on SIGINT, SIGTERM and SIGHUP end the program with status 130 at once; right while
/// nothing has been written, above all while input is read from a terminal or a pipe.
/// A signal that the caller's shell ignores stays ignored.
void exit_on_interrupt();

/// From here on the first of these signals triggers the token and the second one kills.
std::stop_token stop_on_interrupt();

/// Keeps these signals waiting while it lives: a file that comes and goes must also go.
class HoldInterrupt {
 public:
  HoldInterrupt();
  ~HoldInterrupt();
  HoldInterrupt(const HoldInterrupt&) = delete;
  HoldInterrupt& operator=(const HoldInterrupt&) = delete;

 private:
  sigset_t before_;
};

}  // namespace spigolo
