// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/interrupt.cpp
#include "interrupt.h"

#include <unistd.h>

#include <array>
#include <string_view>

namespace spigolo {
namespace {

constexpr std::array<int, 3> handled = {SIGINT, SIGTERM, SIGHUP};

std::stop_source& source() {
  static std::stop_source the_source;
  return the_source;
}

void exit_now(int) {
  constexpr std::string_view message = "\nspigolo: cancelled\n";
  [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, message.data(), message.size());
  ::_exit(status_cancelled);
}

// No stop_callback exists in this program, so request_stop() is a few lock-free atomic operations
// and may be called here.
void request_stop(int) { source().request_stop(); }

void handle_with(void (*handler)(int), int flags) {
  for (const int signal : handled) {
    struct sigaction old {};
    ::sigaction(signal, nullptr, &old);
    if (old.sa_handler == SIG_IGN) continue;
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = flags;
    ::sigaction(signal, &action, nullptr);
  }
}

}  // namespace

void exit_on_interrupt() { handle_with(exit_now, 0); }

std::stop_token stop_on_interrupt() {
  std::stop_token token = source().get_token();  // made before a handler needs it
  handle_with(request_stop, SA_RESTART | static_cast<int>(SA_RESETHAND));
  return token;
}

HoldInterrupt::HoldInterrupt() {
  sigset_t signals;
  ::sigemptyset(&signals);
  for (const int signal : handled) ::sigaddset(&signals, signal);
  ::pthread_sigmask(SIG_BLOCK, &signals, &before_);
}

HoldInterrupt::~HoldInterrupt() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

}  // namespace spigolo
