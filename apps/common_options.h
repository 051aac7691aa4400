// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/common_options.h - the options that all verbs have
#pragma once

#include <cstdint>
#include <string>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace spigolo {

struct CommonOptions {
  int threads = 0;  // 0: all
  bool json = false;
  bool quiet = false;
  std::string progress = "auto";
  std::uint64_t seed = 1;
  std::string params, save_params;  // files; empty: none
  std::string memory;               // as given; empty: what the machine has
};

/// Adds them in one group of the help.
void add_common_options(CLI::App& app, CommonOptions& common);

/// Makes an option of an unsigned type refuse "-1", which would wrap around.
void refuse_negative(CLI::Option& option);

/// Throws UsageError for a --memory that is no size, a --save-params that cannot be written.
void check_common_options(const CommonOptions& common);

/// "512M", "4G", "1.5GiB", "1000000" in bytes; K, M, G, T count by 1024. Throws UsageError.
std::uint64_t parse_size(const std::string& text);

/// "1.5 GiB".
std::string size_text(std::uint64_t bytes);

/// [bytes] that may be used: --memory, or what the machine has.
std::uint64_t memory_limit(const CommonOptions& common);

}  // namespace spigolo
