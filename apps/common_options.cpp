// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/common_options.cpp
#include "common_options.h"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "interrupt.h"
#include "spigolo/core/error.h"
#include "spigolo/io/atomic_file.h"

namespace spigolo {
namespace {

constexpr const char* group = "Options of every verb";
constexpr int most_threads = 1024;

// The power of 1024 a unit stands for; -1 if it is none.
int unit_power(std::string unit) {
  for (char& c : unit) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  if (unit.ends_with("IB")) unit.resize(unit.size() - 2);
  if (unit.ends_with("B")) unit.pop_back();
  if (unit.empty()) return 0;
  const std::size_t at = std::string("KMGT").find(unit);
  return unit.size() > 1 || at == std::string::npos ? -1 : static_cast<int>(at) + 1;
}

}  // namespace

void add_common_options(CLI::App& app, CommonOptions& common) {
  app.set_help_flag("-h,--help", "print this help and exit")->group(group);
  app.add_option("--threads", common.threads, "threads to use (default: all)")
      ->check(CLI::Range(1, most_threads))
      ->type_name("N")
      ->group(group);
  app.add_flag("--json", common.json, "print one JSON document on stdout")->group(group);
  app.add_flag("--quiet", common.quiet, "print neither summary nor warnings nor progress")
      ->group(group);
  app.add_option("--progress", common.progress, "auto (on a terminal), always or never")
      ->check(CLI::IsMember({"auto", "always", "never"}))
      ->type_name("WHEN")
      ->group(group);
  refuse_negative(*app.add_option("--seed", common.seed, "seed of random numbers")
                       ->capture_default_str()
                       ->type_name("N")
                       ->group(group));
  app.add_option("--params", common.params, "take options from this file; the command line wins")
      ->type_name("FILE.json")
      ->group(group);
  app.add_option("--save-params", common.save_params, "save the options used, for --params")
      ->type_name("FILE.json")
      ->group(group);
  app.add_option("--memory", common.memory, "fail early rather than use more, as in 4G")
      ->type_name("SIZE")
      ->group(group);
}

void refuse_negative(CLI::Option& option) {
  option.check(CLI::Validator(
      [](std::string& text) { return text.starts_with('-') ? text + " is negative" : ""; }, ""));
}

void check_common_options(const CommonOptions& common) {
  if (!common.memory.empty()) parse_size(common.memory);
  const HoldInterrupt hold;
  if (!common.save_params.empty()) check_writable(common.save_params);
}

std::uint64_t parse_size(const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  const int power = unit_power(end);
  const double bytes = std::ldexp(number, 10 * power);
  if (end == text.c_str() || power < 0 || !(bytes >= 1 && bytes < 0x1p63))
    throw UsageError("--memory " + text + " is no size; write it like 512M or 4G");
  return static_cast<std::uint64_t>(bytes);
}

std::string size_text(std::uint64_t bytes) {
  constexpr const char* units[] = {"bytes", "KiB", "MiB", "GiB", "TiB"};
  auto number = static_cast<double>(bytes);
  std::size_t unit = 0;
  for (; number >= 1024 && unit < 4; ++unit) number /= 1024;
  char text[48];
  std::snprintf(text, sizeof text, "%.3g %s", number, units[unit]);
  return text;
}

std::uint64_t memory_limit(const CommonOptions& common) {
  if (!common.memory.empty()) return parse_size(common.memory);
  const long pages = ::sysconf(_SC_PHYS_PAGES), page = ::sysconf(_SC_PAGESIZE);
  if (pages <= 0 || page <= 0) return UINT64_MAX;
  return static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(page);
}

}  // namespace spigolo
