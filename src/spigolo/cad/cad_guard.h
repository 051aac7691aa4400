// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/cad/cad_guard.h - CAD files read by a process of their own, which may crash or hang
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "spigolo/cad/cad_file.h"
#include "spigolo/core/job.h"

namespace spigolo {

struct CadGuard {
  // A program and its first arguments, which hands on those that follow to serve_cad_file(). The
  // spigolo program does so for {"spigolo", "serve-cad"}.
  std::vector<std::string> command;
  double seconds = 0;        // [s] of processor for the file, and for each face; 0: 20, and 10 more
                             // for each megabyte of the file
  std::uint64_t memory = 0;  // [bytes] of address space; 0: 4 GB, and 1000 more for each byte
                             // of the file
};

/// As CadFile(path), but OpenCASCADE runs in a child process, started without a shell, which lives
/// as long as the CadFile or a copy of it. Its crash, or more than `seconds`, is an InputError that
/// names the file, whether it comes while the file is read or when a face is asked for; more than
/// `memory` is a MemoryError. May be called while other threads run. Throws Error if the command
/// cannot be started, Cancelled.
CadFile read_cad_file_guarded(const std::filesystem::path& path, const CadGuard& guard,
                              const Job& job = {});

/// The other side: answers on standard input and output, which must be those that
/// read_cad_file_guarded() has made, until they close. arguments: what followed the command.
/// Returns the exit status; 2 if the arguments are none of read_cad_file_guarded().
int serve_cad_file(std::span<const std::string> arguments);

}  // namespace spigolo
