// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/render/png_test.cpp - PNG files against a decoder of their own
#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
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

// Rows of palette numbers, of 4 bits where 16 are enough.
Image looked_up(const Bytes& raw, const Bytes& palette, int width, int height) {
  const bool halves = palette.size() <= 3 * 16;
  const std::size_t row = static_cast<std::size_t>(halves ? (width + 1) / 2 : width) + 1;
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    const unsigned char* in = raw.data() + static_cast<std::size_t>(y) * row;
    EXPECT_EQ(in[0], 0) << "a filter that this decoder does not undo";
    for (int x = 0; x < width; ++x) {
      const int byte = in[1 + (halves ? x / 2 : x)];
      const int entry = !halves ? byte : x % 2 == 0 ? byte >> 4 : byte & 15;
      const unsigned char* p = palette.data() + 3 * static_cast<std::size_t>(entry);
      image.at(x, y) = {p[0], p[1], p[2]};
    }
  }
  return image;
}

Image decode(const std::vector<std::byte>& file) {
  Bytes b(file.size());
  for (std::size_t i = 0; i < b.size(); ++i) b[i] = std::to_integer<unsigned char>(file[i]);
  EXPECT_EQ(std::string(b.begin(), b.begin() + 8), "\x89PNG\r\n\x1a\n");
  Bytes packed, palette;
  int width = 0, height = 0, bits = 0;
  std::string types;
  for (std::size_t at = 8; at < b.size();) {
    const std::size_t length = u32(b, at);
    const std::string type(b.begin() + static_cast<long>(at) + 4,
                           b.begin() + static_cast<long>(at) + 8);
    types += type;
    EXPECT_EQ(crc32_z(0, b.data() + at + 4, length + 4), u32(b, at + 8 + length));
    if (type == "IHDR")
      width = static_cast<int>(u32(b, at + 8)), height = static_cast<int>(u32(b, at + 12)),
      bits = b[at + 16];
    if (type == "PLTE") palette.assign(b.data() + at + 8, b.data() + at + 8 + length);
    if (type == "IDAT") packed.insert(packed.end(), b.data() + at + 8, b.data() + at + 8 + length);
    at += 12 + length;
  }
  EXPECT_EQ(types, palette.empty() ? "IHDRIDATIEND" : "IHDRPLTEIDATIEND");
  const int row = palette.empty() ? 3 * width : (width * bits + 7) / 8;
  uLongf size = static_cast<uLongf>((row + 1) * height);
  Bytes raw(size);
  EXPECT_EQ(uncompress(raw.data(), &size, packed.data(), static_cast<uLong>(packed.size())), Z_OK);
  EXPECT_EQ(size, raw.size());
  return palette.empty() ? unfiltered(raw, width, height) : looked_up(raw, palette, width, height);
}

void expect_round_trip(const Image& image) {
  const Image back = decode(encode_png(image));
  EXPECT_EQ(back.width, image.width);
  EXPECT_EQ(back.height, image.height);
  EXPECT_TRUE(back.pixels == image.pixels);
}

Image noise() {
  Random random(1);
  Image image(37, 23);
  for (Color& c : image.pixels)
    c = {static_cast<std::uint8_t>(random.below(256)), static_cast<std::uint8_t>(random.below(256)),
         static_cast<std::uint8_t>(random.below(256))};
  return image;
}

TEST(Png, NoiseComesBack) { expect_round_trip(noise()); }

TEST(Png, FewColorsAreSmall) {
  EXPECT_LT(2 * encode_png(noise(), 16).size(), encode_png(noise()).size());
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

// Stripes of n colours, an odd number of pixels wide.
Image stripes(int n) {
  Image image(37, 300);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const int c = y % n;
      image.at(x, y) = {static_cast<std::uint8_t>(c), static_cast<std::uint8_t>(7 * c),
                        static_cast<std::uint8_t>(255 - c)};
    }
  return image;
}

TEST(Png, FewColorsComeBackExactly) {
  for (const int n : {1, 2, 16, 17, 256}) {
    const Image image = stripes(n), back = decode(encode_png(image, std::max(n, 2)));
    EXPECT_TRUE(back.pixels == image.pixels) << n;
  }
}

TEST(Png, ManyColorsComeBackNearly) {
  Image image(120, 100);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      image.at(x, y) = {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), 90};
  image.at(60, 50) = {255, 0, 0};
  double squares = 0;
  const Image back = decode(encode_png(image, 64));
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const Color &a = image.pixels[i], &b = back.pixels[i];
    squares += std::pow(a.r - b.r, 2) + std::pow(a.g - b.g, 2) + std::pow(a.b - b.b, 2);
  }
  // 64 even squares of 15 x 12.5 would leave 15^2 / 12 + 12.5^2 / 12 = 31.8
  EXPECT_LT(squares / static_cast<double>(image.pixels.size()), 40);
  EXPECT_TRUE(encode_png(image, 64) == encode_png(image, 64));
}

TEST(Png, OddPalettesAreRefused) {
  for (const int n : {-1, 1, 257}) EXPECT_THROW(encode_png(Image(2, 2), n), UsageError) << n;
}

}  // namespace
}  // namespace spigolo
