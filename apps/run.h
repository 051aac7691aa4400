// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/run.h - what surrounds the front door a verb calls: job, clock, warnings, memory, stdout
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "command_line.h"
#include "progress_bar.h"
#include "spigolo/core/job.h"

namespace spigolo {

class Run {
 public:
  explicit Run(const CommonOptions& common);

  /// Threads, progress bar and the stop token of Ctrl-C; valid while this lives.
  const Job& job();
  /// Seconds since the last call, or since the start.
  double lap();
  double total_seconds() const;

  /// A warning for stderr (unless --quiet) and for the JSON.
  void warn(const std::string& text);
  const std::vector<std::string>& warnings() const { return warnings_; }

  /// Throws MemoryError if a file of that many bytes, or that many points, need more than allowed.
  void check_file_size(const std::filesystem::path& file) const;
  void check_memory(std::size_t points, std::size_t bytes_per_point) const;

  /// The one place that prints results: the JSON, completed by threads, version and warnings, or
  /// the summary. With data_on_stdout the summary goes to stderr.
  void print(Json json, const std::string& summary, bool data_on_stdout = false);

 private:
  using Clock = std::chrono::steady_clock;

  const CommonOptions& common_;
  ProgressBar bar_;
  Job job_;
  Clock::time_point start_ = Clock::now(), lap_ = start_;
  std::vector<std::string> warnings_;
};

/// For the door: throws UsageError if `output` cannot be written, or is "-" together with --json.
void check_output(const std::string& output, const CommonOptions& common);

/// The extension in lower case, with its dot; empty if there is none.
std::string lower_extension(const std::string& path);

}  // namespace spigolo
