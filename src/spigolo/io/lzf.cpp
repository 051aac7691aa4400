// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/lzf.cpp
// A control byte below 32 is followed by that many literal bytes and one. Otherwise its upper three
// bits are a length (7: one more byte adds to it) and its lower five bits with the next byte a
// distance: copy length + 2 bytes from distance + 1 bytes before.
#include "spigolo/io/lzf.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace spigolo {
namespace {

constexpr std::size_t longest_run = 32, longest_match = 264, shortest_match = 3;
constexpr std::size_t window = 8192;
constexpr unsigned table_bits = 14;

std::size_t number(std::byte b) { return std::to_integer<std::size_t>(b); }

// Bucket of the three bytes at p.
std::size_t bucket(const std::byte* p) {
  const auto key =
      static_cast<std::uint32_t>(number(p[0]) | number(p[1]) << 8 | number(p[2]) << 16);
  return key * 2654435761u >> (32 - table_bits);
}

void put_literals(std::vector<std::byte>& out, std::span<const std::byte> bytes) {
  for (std::size_t at = 0; at < bytes.size(); at += longest_run) {
    const auto run = bytes.subspan(at, std::min(longest_run, bytes.size() - at));
    out.push_back(static_cast<std::byte>(run.size() - 1));
    out.insert(out.end(), run.begin(), run.end());
  }
}

void put_match(std::vector<std::byte>& out, std::size_t distance, std::size_t length) {
  const std::size_t code = length - 2, back = distance - 1;
  out.push_back(static_cast<std::byte>(std::min<std::size_t>(code, 7) << 5 | back >> 8));
  if (code >= 7) out.push_back(static_cast<std::byte>(code - 7));
  out.push_back(static_cast<std::byte>(back & 0xff));
}

std::size_t match_length(std::span<const std::byte> in, std::size_t a, std::size_t b) {
  const std::size_t limit = std::min(longest_match, in.size() - b);
  std::size_t length = 0;
  while (length < limit && in[a + length] == in[b + length]) ++length;
  return length;
}

}  // namespace

bool lzf_decompress(std::span<const std::byte> in, std::span<std::byte> out) {
  std::size_t i = 0, o = 0;
  while (i < in.size()) {
    const std::size_t control = number(in[i++]);
    if (control < longest_run) {
      const std::size_t run = control + 1;
      if (run > in.size() - i || run > out.size() - o) return false;
      std::memcpy(out.data() + o, in.data() + i, run);
      i += run, o += run;
      continue;
    }
    std::size_t length = (control >> 5) + 2;
    if (length == 9 && i < in.size()) length += number(in[i++]);
    if (i == in.size()) return false;
    const std::size_t distance = ((control & 31) << 8 | number(in[i++])) + 1;
    if (distance > o || length > out.size() - o) return false;
    // Byte by byte: the copy may overlap itself, and then repeats.
    for (const std::size_t stop = o + length; o < stop; ++o) out[o] = out[o - distance];
  }
  return o == out.size();
}

std::vector<std::byte> lzf_compress(std::span<const std::byte> in) {
  std::vector<std::byte> out;
  std::vector<std::size_t> last(std::size_t{1} << table_bits, in.size());
  std::size_t pending = 0, i = 0;
  while (i + shortest_match <= in.size()) {
    std::size_t& candidate = last[bucket(in.data() + i)];
    const bool near = candidate < i && i - candidate <= window;
    const std::size_t length = near ? match_length(in, candidate, i) : 0;
    const std::size_t distance = i - candidate;
    candidate = i;
    if (length < shortest_match) {
      ++i;
      continue;
    }
    put_literals(out, in.subspan(pending, i - pending));
    put_match(out, distance, length);
    i += length;
    pending = i;
  }
  put_literals(out, in.subspan(pending));
  return out;
}

}  // namespace spigolo
