// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/meshing_clouds.h - meshes of scans, models and large clouds
#pragma once

#include <filesystem>

#include "report.h"

namespace spigolo::bench {

/// Simulated scans that see only some sides; with a data folder its models and abc/clean as well.
void mesh_clouds(Report& report, const std::filesystem::path& data);

/// 100 000 points, with `large` a million as well: time and memory.
void mesh_speed(Report& report, bool large);

}  // namespace spigolo::bench
