// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/image.h - a picture in memory and its PNG file
#pragma once

#include <cstddef>
#include <vector>

#include "spigolo/render/palette.h"

namespace spigolo {

/// Rows from the top, pixels from the left.
struct Image {
  int width = 0, height = 0;
  std::vector<Color> pixels;  // width * height

  Image() = default;
  Image(int w, int h, Color fill = {255, 255, 255});
  bool contains(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(x);
  }
  const Color& at(int x, int y) const { return pixels[index(x, y)]; }
  Color& at(int x, int y) { return pixels[index(x, y)]; }
};

/// The bytes of a PNG file, one IDAT chunk, no time stamp, so equal images give equal bytes.
/// colors: 0: 8-bit RGB, every pixel as it is; 2 to 256: a palette of at most so many (quantize.h),
/// a fraction of the size. Throws UsageError for an image without pixels or another number.
std::vector<std::byte> encode_png(const Image& image, int colors = 0);

}  // namespace spigolo
