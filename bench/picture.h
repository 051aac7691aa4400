// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/picture.h - pictures on their way to the disk
#pragma once

#include <filesystem>

#include "spigolo/render/render.h"

namespace spigolo::bench {

/// What the repository keeps: shading in so few colours is a tenth of the size and looks the same.
inline constexpr int kept_colors = 32;

/// Nothing around the scene, white behind it (a gradient costs bytes), seen along `direction`
/// ("25,35", "auto" ...).
RenderOptions bare_look(int width, int height, const char* direction = "auto");

/// As PNG; the folder is made if need be. colors: as of encode_png.
void save_picture(const std::filesystem::path& file, const Image& image, int colors = 0);

}  // namespace spigolo::bench
