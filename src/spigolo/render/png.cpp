// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/png.cpp - PNG (ISO/IEC 15948): 8-bit RGB, the row filter chosen by the smallest
// sum; or a palette with 4 or 8 bits a pixel, not filtered, since its numbers have no order
#include <zlib.h>

#include <array>
#include <cstdlib>
#include <string_view>

#include "spigolo/core/error.h"
#include "spigolo/render/image.h"
#include "spigolo/render/quantize.h"

namespace spigolo {
namespace {

using Bytes = std::vector<std::uint8_t>;
constexpr std::size_t channels = 3;
constexpr int filters = 5;
constexpr int usual_level = 6, best_level = 9;  // of zlib
constexpr std::size_t half_byte_palette = 16;   // entries that 4 bits can name

void append_u32(Bytes& out, std::uint32_t v) {
  for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<std::uint8_t>(v >> shift));
}

void append_chunk(Bytes& out, std::string_view type, const Bytes& data) {
  append_u32(out, static_cast<std::uint32_t>(data.size()));
  const std::size_t start = out.size();
  out.insert(out.end(), type.begin(), type.end());
  out.insert(out.end(), data.begin(), data.end());
  const uLong sum = crc32_z(0, out.data() + start, out.size() - start);
  append_u32(out, static_cast<std::uint32_t>(sum));
}

int paeth(int left, int up, int corner) {
  const int guess = left + up - corner;
  const int dl = std::abs(guess - left), du = std::abs(guess - up), dc = std::abs(guess - corner);
  if (dl <= du && dl <= dc) return left;
  return du <= dc ? up : corner;
}

int predict(int filter, int left, int up, int corner) {
  switch (filter) {
    case 1:
      return left;
    case 2:
      return up;
    case 3:
      return (left + up) / 2;
    case 4:
      return paeth(left, up, corner);
    default:
      return 0;
  }
}

// Writes the filtered row and returns the sum of its bytes taken as signed: small means
// compressible.
std::uint64_t filter_row(int filter, const Bytes& row, const Bytes& above, Bytes& out) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const int left = i < channels ? 0 : row[i - channels];
    const int corner = i < channels ? 0 : above[i - channels];
    const auto byte = static_cast<std::uint8_t>(row[i] - predict(filter, left, above[i], corner));
    out[i] = byte;
    sum += byte < 128 ? byte : 256u - byte;
  }
  return sum;
}

Bytes row_bytes(const Image& image, int y) {
  Bytes row;
  row.reserve(static_cast<std::size_t>(image.width) * channels);
  for (int x = 0; x < image.width; ++x) {
    const Color& c = image.at(x, y);
    row.insert(row.end(), {c.r, c.g, c.b});
  }
  return row;
}

Bytes filtered(const Image& image) {
  const std::size_t length = static_cast<std::size_t>(image.width) * channels;
  Bytes above(length), trial(length), best(length), out;
  out.reserve((length + 1) * static_cast<std::size_t>(image.height));
  for (int y = 0; y < image.height; ++y) {
    Bytes row = row_bytes(image, y);
    std::uint64_t best_sum = ~std::uint64_t{0};
    int best_filter = 0;
    for (int filter = 0; filter < filters; ++filter) {
      const std::uint64_t sum = filter_row(filter, row, above, trial);
      if (sum >= best_sum) continue;
      best_sum = sum, best_filter = filter;
      best.swap(trial);
    }
    out.push_back(static_cast<std::uint8_t>(best_filter));
    out.insert(out.end(), best.begin(), best.end());
    above.swap(row);
  }
  return out;
}

Bytes deflated(const Bytes& raw, int level) {
  uLongf size = compressBound(static_cast<uLong>(raw.size()));
  Bytes out(size);
  if (compress2(out.data(), &size, raw.data(), static_cast<uLong>(raw.size()), level) != Z_OK)
    throw Error("the picture cannot be compressed");
  out.resize(size);
  return out;
}

Bytes palette_bytes(const std::vector<Color>& palette) {
  Bytes bytes;
  for (const Color& c : palette) bytes.insert(bytes.end(), {c.r, c.g, c.b});
  return bytes;
}

// Rows of palette numbers, each behind the number of its filter (none); the left pixel of two in
// the upper half of a byte.
Bytes packed_rows(const FewColors& few, std::size_t width, bool halves) {
  Bytes out;
  out.reserve(few.pixels.size() + few.pixels.size() / width);
  for (std::size_t row = 0; row < few.pixels.size(); row += width) {
    out.push_back(0);
    for (std::size_t x = 0; x < width; x += halves ? 2 : 1) {
      const std::uint8_t left = few.pixels[row + x];
      const std::uint8_t right = halves && x + 1 < width ? few.pixels[row + x + 1] : 0;
      out.push_back(halves ? static_cast<std::uint8_t>(left << 4 | right) : left);
    }
  }
  return out;
}

// The chunks of a file around those that hold the colours and pixels.
std::vector<std::byte> png_file(const Image& image, std::uint8_t bits, std::uint8_t color_type,
                                const Bytes& palette, const Bytes& rows) {
  Bytes out = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  Bytes header;
  append_u32(header, static_cast<std::uint32_t>(image.width));
  append_u32(header, static_cast<std::uint32_t>(image.height));
  header.insert(header.end(), {bits, color_type, 0, 0, 0});  // deflate, filters, not interlaced
  append_chunk(out, "IHDR", header);
  if (!palette.empty()) append_chunk(out, "PLTE", palette);
  append_chunk(out, "IDAT", deflated(rows, palette.empty() ? usual_level : best_level));
  append_chunk(out, "IEND", {});
  std::vector<std::byte> bytes(out.size());
  for (std::size_t i = 0; i < out.size(); ++i) bytes[i] = std::byte{out[i]};
  return bytes;
}

}  // namespace

Image::Image(int w, int h, Color fill)
    : width(w),
      height(h),
      pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), fill) {}

std::vector<std::byte> encode_png(const Image& image, int colors) {
  if (image.width < 1 || image.height < 1) throw UsageError("a picture without pixels");
  constexpr std::uint8_t rgb = 2, indexed = 3;
  if (colors == 0) return png_file(image, 8, rgb, {}, filtered(image));
  const FewColors few = quantize(image, colors);
  const bool halves = few.palette.size() <= half_byte_palette;
  return png_file(image, halves ? 4 : 8, indexed, palette_bytes(few.palette),
                  packed_rows(few, static_cast<std::size_t>(image.width), halves));
}

}  // namespace spigolo
