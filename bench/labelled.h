// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/labelled.h - clouds whose sharp points are red
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "spigolo/measure/classification.h"

namespace spigolo::bench {

struct LabelledCloud {
  std::string name;
  std::vector<Vec3> points;
  FeatureTruth truth;  // for the thin score; edge distances are not known
};

/// All .ply of the folder, in the order of their names. Throws InputError for one without colours.
std::vector<LabelledCloud> read_labelled(const std::filesystem::path& folder);

}  // namespace spigolo::bench
