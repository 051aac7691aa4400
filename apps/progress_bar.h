// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/progress_bar.h - one line on stderr that says how far a job is
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

namespace spigolo {

/// "stage [#####.....] 50%, 3 s left", redrawn ten times a second at most. Carriage returns and
/// blanks are all it needs: no colour, no escape codes, so NO_COLOR has nothing to switch off.
class ProgressBar {
 public:
  explicit ProgressBar(bool visible) : visible_(visible) {}
  ~ProgressBar() { erase(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void show(std::string_view stage, double share);
  /// Leaves an empty line with the cursor at its start.
  void erase();

 private:
  using Clock = std::chrono::steady_clock;
  void draw(const std::string& line);

  bool visible_;
  std::size_t drawn_ = 0;  // columns on the screen
  std::string stage_;
  Clock::time_point stage_start_{}, last_drawn_{};
};

/// The line without carriage return; seconds: since the stage began.
std::string progress_line(std::string_view stage, double share, double seconds);

/// choice: "auto" (only where stderr is a terminal), "always" or "never".
bool progress_visible(const std::string& choice, bool quiet);

}  // namespace spigolo
