// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/run.cpp
#include "run.h"

#include <algorithm>
#include <cstdio>
#include <system_error>

#include "interrupt.h"
#include "spigolo/core/error.h"
#include "spigolo/core/parallel.h"
#include "spigolo/io/atomic_file.h"

namespace spigolo {
namespace {

[[noreturn]] void over_limit(const std::string& what, std::uint64_t needed, std::uint64_t limit) {
  throw MemoryError(what + " needs about " + size_text(needed) + " of memory, more than the " +
                    size_text(limit) + " allowed; raise --memory or thin the cloud");
}

void print_text(const std::string& text, std::FILE* stream) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stream) == text.size();
  if ((!written || std::fflush(stream) != 0) && stream == stdout)
    throw Error("standard output cannot be written; is its disk full?");
}

}  // namespace

Run::Run(const CommonOptions& common)
    : common_(common), bar_(progress_visible(common.progress, common.quiet)) {
  job_.threads = common.threads;
  job_.progress = [this](std::string_view stage, double share) { bar_.show(stage, share); };
}

const Job& Run::job() {
  if (!job_.stop.stop_possible()) job_.stop = stop_on_interrupt();
  return job_;
}

double Run::lap() {
  const auto now = Clock::now();
  const std::chrono::duration<double> passed = now - lap_;
  lap_ = now;
  return passed.count();
}

double Run::total_seconds() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

void Run::warn(const std::string& text) {
  warnings_.push_back(text);
  if (common_.quiet) return;
  bar_.erase();
  print_text("spigolo: warning: " + text + "\n", stderr);
}

void Run::check_file_size(const std::filesystem::path& file) const {
  std::error_code problem;
  const std::uintmax_t bytes = std::filesystem::file_size(file, problem);
  const std::uint64_t limit = memory_limit(common_);
  if (!problem && bytes > limit) over_limit("reading " + file.string(), bytes, limit);
}

void Run::check_memory(std::size_t points, std::size_t bytes_per_point) const {
  const std::uint64_t limit = memory_limit(common_);
  if (points <= limit / bytes_per_point) return;
  const bool overflows = points > UINT64_MAX / bytes_per_point;
  over_limit("a cloud of " + std::to_string(points) + " points",
             overflows ? UINT64_MAX : points * bytes_per_point, limit);
}

void Run::print(Json json, const std::string& summary, bool data_on_stdout) {
  bar_.erase();
  if (common_.json) {
    json["threads"] = thread_count(job_);
    json["version"] = SPIGOLO_VERSION;
    json["warnings"] = warnings_;
    // File names may be in any encoding; JSON is UTF-8.
    print_text(json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n", stdout);
  } else if (!common_.quiet) {
    print_text(summary, data_on_stdout ? stderr : stdout);
  }
}

void check_output(const std::string& output, const CommonOptions& common) {
  if (output == "-" && common.json)
    throw UsageError("--json and -o - both want standard output; write to a file instead");
  const HoldInterrupt hold;
  check_writable(output);
}

std::string lower_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

}  // namespace spigolo
