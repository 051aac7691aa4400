// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/quantize.h - a picture in a few colours of its own choice
#pragma once

#include <cstdint>
#include <vector>

#include "spigolo/render/image.h"

namespace spigolo {

/// The picture's pixels as entries of a palette.
struct FewColors {
  std::vector<Color> palette;        // at most as many as asked for, all used
  std::vector<std::uint8_t> pixels;  // as Image::pixels
};

/// At most `colors` (2 to 256) colours that stand for all with a small sum of squared differences;
/// exact where the picture has no more. The same for equal pictures. Throws UsageError for another
/// number.
FewColors quantize(const Image& image, int colors);

}  // namespace spigolo
