// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/blend_pictures.h - blends side by side, collar and face coloured
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "spigolo/blend/blend.h"

namespace spigolo::bench {

struct PictureOf {
  std::string title;
  Blend blend;
};

/// Panels seen from above and beside, all of one width [pixel].
void draw_blends(const std::vector<PictureOf>& blends, const std::filesystem::path& file, int rows,
                 int columns = 4, int panel_width = 220);

}  // namespace spigolo::bench
