// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/render/png_test.cpp - PNG files against a decoder of their own
#include <gtest/gtest.h>
#include <zlib.h>

#include <cstdlib>
#include <string>

#include "spigolo/core/error.h"
#include "spigolo/core/random.h"
#include "spigolo/render/image.h"

namespace spigolo {
namespace {

using Bytes = std::vector<unsigned char>;

std::uint32_t u32(const Bytes& b, std::size_t at) {
  return std::uint32_t{b[at]} << 24 | std::uint32_t{b[at + 1]} << 16 |
         std::uint32_t{b[at + 2]} << 8 | b[at + 3];
}

int paeth(int a, int b, int c) {
  const int p = a + b - c, pa = std::abs(p - a), pb = std::abs(p - b), pc = std::abs(p - c);
  return pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
}

// Undoes the row filters of the standard, 3 bytes a pixel.
Image unfiltered(const Bytes& raw, int width, int height) {
  Image image(width, height);
  const std::size_t row = static_cast<std::size_t>(width) * 3;
  Bytes above(row), line(row);
  for (int y = 0; y < height; ++y) {
    const unsigned char* in = raw.data() + static_cast<std::size_t>(y) * (row + 1);
    for (std::size_t i = 0; i < row; ++i) {
      const int a = i < 3 ? 0 : line[i - 3], b = above[i], c = i < 3 ? 0 : above[i - 3];
      const int guess[5] = {0, a, b, (a + b) / 2, paeth(a, b, c)};
      line[i] = static_cast<unsigned char>(in[i + 1] + guess[in[0]]);
    }
    for (int x = 0; x < width; ++x) {
      const unsigned char* p = line.data() + 3 * static_cast<std::size_t>(x);
      image.at(x, y) = {p[0], p[1], p[2]};
    }
    above = line;
  }
  return image;
}

Image decode(const std::vector<std::byte>& file) {
  Bytes b(file.size());
  for (std::size_t i = 0; i < b.size(); ++i) b[i] = std::to_integer<unsigned char>(file[i]);
  EXPECT_EQ(std::string(b.begin(), b.begin() + 8), "\x89PNG\r\n\x1a\n");
  Bytes packed;
  int width = 0, height = 0;
  std::string types;
  for (std::size_t at = 8; at < b.size();) {
    const std::size_t length = u32(b, at);
    const std::string type(b.begin() + static_cast<long>(at) + 4,
                           b.begin() + static_cast<long>(at) + 8);
    types += type;
    EXPECT_EQ(crc32_z(0, b.data() + at + 4, length + 4), u32(b, at + 8 + length));
    if (type == "IHDR")
      width = static_cast<int>(u32(b, at + 8)), height = static_cast<int>(u32(b, at + 12));
    if (type == "IDAT") packed.insert(packed.end(), b.data() + at + 8, b.data() + at + 8 + length);
    at += 12 + length;
  }
  EXPECT_EQ(types, "IHDRIDATIEND");
  uLongf size = static_cast<uLongf>((width * 3 + 1) * height);
  Bytes raw(size);
  EXPECT_EQ(uncompress(raw.data(), &size, packed.data(), static_cast<uLong>(packed.size())), Z_OK);
  EXPECT_EQ(size, raw.size());
  return unfiltered(raw, width, height);
}

void expect_round_trip(const Image& image) {
  const Image back = decode(encode_png(image));
  EXPECT_EQ(back.width, image.width);
  EXPECT_EQ(back.height, image.height);
  EXPECT_TRUE(back.pixels == image.pixels);
}

TEST(Png, NoiseComesBack) {
  Random random(1);
  Image image(37, 23);
  for (Color& c : image.pixels)
    c = {static_cast<std::uint8_t>(random.below(256)), static_cast<std::uint8_t>(random.below(256)),
         static_cast<std::uint8_t>(random.below(256))};
  expect_round_trip(image);
}

TEST(Png, SmoothPicturesComeBackAndShrink) {
  Image image(200, 150);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      image.at(x, y) = {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y),
                        static_cast<std::uint8_t>((x * x + y * y) / 256)};
  expect_round_trip(image);
  EXPECT_LT(encode_png(image).size(), image.pixels.size());
}

TEST(Png, OnePixelComesBack) { expect_round_trip(Image(1, 1, {1, 2, 3})); }

TEST(Png, NoPixelIsRefused) { EXPECT_THROW(encode_png(Image()), UsageError); }

}  // namespace
}  // namespace spigolo
