// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/font.cpp
#include "spigolo/render/font.h"

#include <array>
#include <string_view>

namespace spigolo {
namespace {

// One entry a character from ' ' on: the advance (a is 10), then strokes, each '-' for straight or
// '~' for curved (a quadratic B-spline, closed if it ends where it began) and its points: a digit
// for x, a letter for y with 'd' on the base line, 'j' the height of small letters, 'm' of
// capitals.
constexpr std::array<std::string_view, 95> table = {
    "4",                                        // space
    "3 -1m1g -1d",                              // !
    "5 -1m1j -3m3j",                            // "
    "9 -1d3m -4d6m -0g7g -0j7j",                // #
    "8 ~6k6m0m0i6h6d0d0f -3n3c",                // $
    "a ~0m3m3j0j0m ~5g8g8d5d5g -1d7m",          // %
    "9 -7d1k ~1k1m5m5k ~5k5j0i0f ~0f0d6d7h",    // &
    "3 -1m1j",                                  // '
    "4 ~3n0k0e3b",                              // (
    "4 ~0n3k3e0b",                              // )
    "7 -3m3g -0k6h -6k0h",                      // *
    "8 -3e3k -0h6h",                            // +
    "3 -1d0b",                                  // ,
    "6 -0h4h",                                  // -
    "3 -1d",                                    // .
    "6 -0c4n",                                  // /
    "7 ~0d5d5m0m0d",                            // 0
    "7 -1k3m3d -1d5d",                          // 1
    "7 ~0k0m5m5i2g0d -0d5d",                    // 2
    "7 ~0l1m5m5i2i ~2i5i5d0d0f",                // 3
    "7 -4d4m0f5f",                              // 4
    "7 -5m1m0i ~0i2j5j5d1d0e",                  // 5
    "7 ~4m0k0f ~0d5d5i0i0d",                    // 6
    "7 -0m5m2d",                                // 7
    "7 ~0m5m5i0i0m ~0i5i5d0d0i",                // 8
    "7 ~5m0m0h5h5m ~5k5f1d",                    // 9
    "3 -1d -1i",                                // :
    "3 -1i -1d0b",                              // ;
    "7 -5k0h5e",                                // <
    "7 -0i5i -0f5f",                            // =
    "7 -0k5h0e",                                // >
    "7 ~0k0m5m5j2i2g -2d",                      // ?
    "a ~7d0c0m8m8f5e6j ~6j2k2f6f6j",            // @
    "8 -0d3m6d -1g5g",                          // A
    "8 -3m0m0d3d -0i3i ~3m6m6i3i ~3i7i7d3d",    // B
    "8 ~6k6m0m0d6d6f",                          // C
    "8 -2m0m0d2d ~2m7m7d2d",                    // D
    "7 -5m0m0d5d -0i4i",                        // E
    "7 -5m0m0d -0i4i",                          // F
    "8 ~6k6m0m0d6d6h -6h3h",                    // G
    "8 -0d0m -6d6m -0i6i",                      // H
    "3 -1d1m",                                  // I
    "6 -4m4g ~4g4d0d0f",                        // J
    "8 -0d0m -6m0g -2i6d",                      // K
    "7 -0m0d5d",                                // L
    "a -0d0m4f8m8d",                            // M
    "8 -0d0m6d6m",                              // N
    "9 ~0d7d7m0m0d",                            // O
    "8 -0d0m3m -0h3h ~3m7m7h3h",                // P
    "9 ~0d7d7m0m0d -4f7c",                      // Q
    "8 -0d0m3m -0h3h ~3m7m7h3h -3h6d",          // R
    "8 ~6k6m0m0i6h6d0d0f",                      // S
    "8 -0m6m -3m3d",                            // T
    "8 -0m0g -6m6g ~0g0d6d6g",                  // U
    "8 -0m3d6m",                                // V
    "a -0m2d4l6d8m",                            // W
    "8 -0m6d -0d6m",                            // X
    "8 -0m3h6m -3h3d",                          // Y
    "8 -0m6m0d6d",                              // Z
    "4 -3n1n1b3b",                              // [
    "6 -0n4c",                                  // backslash
    "4 -0n2n2b0b",                              // ]
    "6 -0i2m4i",                                // ^
    "7 -0b5b",                                  // _
    "4 -0m2k",                                  // `
    "7 ~0d5d5j0j0d -5j5d",                      // a
    "7 -0m0d ~0d5d5j0j0d",                      // b
    "7 ~5h5j0j0d5d5f",                          // c
    "7 ~0d5d5j0j0d -5m5d",                      // d
    "7 -0g5g ~5g5j0j0d4d5e",                    // e
    "5 ~4m1n1j -1j1d -0j4j",                    // f
    "7 ~0d5d5j0j0d -5j5d ~5d5a1a0b",            // g
    "7 -0m0d ~0g0j5j5g -5g5d",                  // h
    "3 -1j1d -1m",                              // i
    "4 -2j2c ~2c2a0a -2m",                      // j
    "6 -0m0d -4j0f -1g5d",                      // k
    "4 -1m1f ~1f1d3d",                          // l
    "a -0j0d ~0g0j4j4g -4g4d ~4g4j8j8g -8g8d",  // m
    "7 -0j0d ~0g0j5j5g -5g5d",                  // n
    "7 ~0d5d5j0j0d",                            // o
    "7 -0j0a ~0d5d5j0j0d",                      // p
    "7 -5j5a ~0d5d5j0j0d",                      // q
    "5 -0j0d ~0g0j4j",                          // r
    "6 ~4i4j0j0g4g4d0d0e",                      // s
    "5 -1m1f ~1f1d4d -0j4j",                    // t
    "7 -0j0g ~0g0d5d5g -5j5d",                  // u
    "6 -0j2d4j",                                // v
    "a -0j2d4j6d8j",                            // w
    "6 -0j4d -0d4j",                            // x
    "6 -0j2d -4j1a0a",                          // y
    "6 -0j4j0d4d",                              // z
    "4 ~3n1n2h0h ~0h2h1b3b",                    // {
    "3 -1n1b",                                  // |
    "4 ~0n2n1h3h ~3h1h2b0b",                    // }
    "7 ~0g1j4f5i",                              // ~
};

std::vector<Vec3> points_of(std::string_view text) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i + 1 < text.size(); i += 2)
    points.push_back({double(text[i] - '0'), double(text[i + 1] - 'd'), 0});
  return points;
}

void append_arc(std::vector<Vec3>& out, Vec3 a, const Vec3& b, const Vec3& c) {
  constexpr int pieces = 8;
  for (int k = 1; k <= pieces; ++k) {
    const double t = double(k) / pieces, s = 1 - t;
    out.push_back(s * s * a + 2 * s * t * b + t * t * c);
  }
}

std::vector<Vec3> curved(const std::vector<Vec3>& p) {
  const bool closed = p.front() == p.back();
  const std::size_t n = p.size() - 1;
  const auto middle = [&](std::size_t i) { return (p[i] + p[i + 1]) * 0.5; };
  std::vector<Vec3> out = {closed ? middle(0) : p[0]};
  for (std::size_t i = 1; i < n; ++i) {
    append_arc(out, out.back(), p[i], i + 1 < n || closed ? middle(i) : p[n]);
  }
  if (closed) append_arc(out, out.back(), p[0], middle(0));
  return out;
}

Glyph parse(std::string_view text) {
  Glyph glyph;
  glyph.advance = text[0] == 'a' ? 10 : text[0] - '0';
  text.remove_prefix(1);
  while (!text.empty()) {
    text.remove_prefix(1);
    const std::string_view stroke = text.substr(0, text.find(' '));
    const std::vector<Vec3> points = points_of(stroke.substr(1));
    glyph.strokes.push_back(stroke[0] == '~' ? curved(points) : points);
    text.remove_prefix(stroke.size());
  }
  return glyph;
}

std::vector<Glyph> parse_all() {
  std::vector<Glyph> glyphs;
  for (const std::string_view text : table) glyphs.push_back(parse(text));
  return glyphs;
}

}  // namespace

const Glyph& glyph(char c) {
  static const std::vector<Glyph> glyphs = parse_all();
  const bool known = c >= ' ' && c <= '~';
  return glyphs[static_cast<std::size_t>((known ? c : '?') - ' ')];
}

}  // namespace spigolo
