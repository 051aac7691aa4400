// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/environment.cpp
#include "environment.h"

#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <thread>

namespace spigolo::bench {
namespace {

/// What stands behind the first line that begins with `key`, without quotes; empty if none does.
std::string value_of(const char* file, const std::string& key) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with(key)) continue;
    std::string value = line.substr(key.size());
    std::erase(value, '"');
    return value.substr(std::min(value.size(), value.find_first_not_of("\t :=")));
  }
  return "";
}

std::string or_unknown(const std::string& text) { return text.empty() ? "not known" : text; }

/// Of the folder the run was started in; '+' after it: with changes that are not committed.
std::string commit() {
  std::FILE* pipe = popen("git describe --always --dirty=+ 2>/dev/null", "r");
  if (pipe == nullptr) return "";
  char text[64] = "";
  const bool read = std::fgets(text, sizeof text, pipe) != nullptr;
  pclose(pipe);
  std::string line = read ? text : "";
  std::erase(line, '\n');
  return line;
}

std::string memory() {
  const double bytes =
      static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
  return number(bytes / (1024.0 * 1024.0 * 1024.0)) + " GiB";
}

}  // namespace

void environment(Report& report) {
  report.heading(2, "Versions and machine");
  report.table({"what", "which"},
               {{"spigolo", std::string(SPIGOLO_VERSION) + ", commit " + or_unknown(commit())},
                {"compiler", SPIGOLO_COMPILER},
                {"Eigen", SPIGOLO_EIGEN},
                {"TBB", SPIGOLO_TBB},
                {"Highway", SPIGOLO_HIGHWAY},
                {"OpenCASCADE", SPIGOLO_OCCT},
                {"system", or_unknown(value_of("/etc/os-release", "PRETTY_NAME"))},
                {"processor", or_unknown(value_of("/proc/cpuinfo", "model name"))},
                {"cores", std::to_string(std::thread::hardware_concurrency())},
                {"memory", memory()}});
}

}  // namespace spigolo::bench
