// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/cad_reader.h - CAD files, read by another process of this program
#pragma once

#include <string>
#include <vector>

#include "common_options.h"
#include "spigolo/cad/cad_file.h"

namespace spigolo {

/// A damaged file may crash OpenCASCADE, or have it run for ever: it then does so in a process of
/// its own, and this one throws InputError.
CadFile read_cad(const std::string& path, const CommonOptions& common);

/// That other process: the verb serve-cad, which no help names.
inline constexpr const char* serve_cad_verb = "serve-cad";
void run_serve_cad(const std::vector<std::string>& arguments);

}  // namespace spigolo
