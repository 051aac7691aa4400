// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/blend_meshes.h - meshes of blends, checked and drawn
#pragma once

#include <filesystem>
#include <string>

#include "report.h"

namespace spigolo::bench {

/// A table, and one picture a blend. data: folder with fandisk.off, may be empty.
void blend_meshes(Report& report, const std::string& data, const std::filesystem::path& pictures);

}  // namespace spigolo::bench
