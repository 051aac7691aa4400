// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/cad_reader.cpp
#include "cad_reader.h"

#include <filesystem>

#include "spigolo/cad/cad_guard.h"
#include "spigolo/core/error.h"

namespace spigolo {
namespace {

constexpr const char* this_program = "/proc/self/exe";
constexpr std::uint64_t own_memory = std::uint64_t{1} << 29;  // of the program and its libraries

}  // namespace

CadFile read_cad(const std::string& path, const CommonOptions& common) {
  std::error_code error;
  // Where a program cannot find itself, it reads unguarded.
  if (!std::filesystem::exists(this_program, error)) return CadFile(path);
  CadGuard guard;
  guard.command = {this_program, serve_cad_verb};
  if (!common.memory.empty()) guard.memory = memory_limit(common) + own_memory;
  return read_cad_file_guarded(path, guard);
}

void run_serve_cad(const std::vector<std::string>& arguments) {
  if (serve_cad_file(arguments) != 0)
    throw UsageError("serve-cad is how this program reads CAD files, and nothing to call by hand");
}

}  // namespace spigolo
