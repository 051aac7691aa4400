// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/progress_bar.cpp
#include "progress_bar.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace spigolo {
namespace {

constexpr std::size_t cells = 24;
constexpr std::chrono::milliseconds redraw{100};
constexpr double settled = 0.5;  // [s] before this an estimate of the rest jumps about

std::string remaining_text(double seconds) {
  const auto whole = static_cast<long>(std::ceil(seconds));
  if (whole < 60) return std::to_string(whole) + " s left";
  if (whole < 3600) return std::to_string((whole + 59) / 60) + " min left";
  return std::to_string(whole / 3600) + " h " + std::to_string(whole % 3600 / 60) + " min left";
}

}  // namespace

std::string progress_line(std::string_view stage, double share, double seconds) {
  share = std::clamp(share, 0.0, 1.0);
  const auto full = static_cast<std::size_t>(share * static_cast<double>(cells));
  std::string line(stage);
  line += " [" + std::string(full, '#') + std::string(cells - full, '.') + "] ";
  line += std::to_string(static_cast<int>(share * 100)) + "%";
  if (seconds > settled && share > 0 && share < 1)
    line += ", " + remaining_text(seconds / share * (1 - share));
  return line;
}

void ProgressBar::show(std::string_view stage, double share) {
  if (!visible_) return;
  const auto now = Clock::now();
  if (stage != stage_) {
    stage_ = stage;
    stage_start_ = now;
  } else if (now - last_drawn_ < redraw) {
    return;
  }
  last_drawn_ = now;
  const std::chrono::duration<double> elapsed = now - stage_start_;
  draw(progress_line(stage, share, elapsed.count()));
}

void ProgressBar::draw(const std::string& line) {
  const std::size_t blanks = drawn_ > line.size() ? drawn_ - line.size() : 0;
  const std::string text = "\r" + line + std::string(blanks, ' ');
  std::fputs(text.c_str(), stderr);
  std::fflush(stderr);
  drawn_ = line.size();
}

void ProgressBar::erase() {
  if (drawn_ == 0) return;
  draw("");
  std::fputs("\r", stderr);
  std::fflush(stderr);
}

bool progress_visible(const std::string& choice, bool quiet) {
  if (choice != "auto") return choice == "always";
  return !quiet && ::isatty(STDERR_FILENO) == 1;
}

}  // namespace spigolo
