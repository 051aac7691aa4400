// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/index/radix_sort.cpp - least significant digit first, in blocks that are scattered at
// once
#include "spigolo/index/radix_sort.h"

#include <algorithm>
#include <array>
#include <utility>

#include "spigolo/core/parallel.h"

namespace spigolo {
namespace {

constexpr std::size_t block_size = 1 << 16;
constexpr std::size_t digit_values = std::size_t{1} << radix_digit_bits;
using Counts = std::array<std::uint32_t, digit_values>;

std::size_t digit(const CodeKey& key, int shift) { return key.code >> shift & (digit_values - 1); }

// From how often each block has each digit to where its first one goes: digit by digit, then block
// by block, which keeps the sort stable.
void make_places(std::vector<Counts>& counts) {
  std::uint32_t sum = 0;
  for (std::size_t value = 0; value < digit_values; ++value)
    for (Counts& block : counts) sum += std::exchange(block[value], sum);
}

}  // namespace

void radix_sort(std::vector<CodeKey>& keys, int lowest, int digits, const Job& job) {
  std::vector<CodeKey> other(keys.size());
  std::vector<Counts> counts((keys.size() + block_size - 1) / block_size);
  const auto for_each_key = [&](const auto& body) {
    parallel_for(job, "", keys.size(), block_size, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) body(keys[i], counts[begin / block_size]);
    });
  };
  for (int d = 0; d < digits; ++d) {
    const int shift = lowest + d * radix_digit_bits;
    for (Counts& block : counts) block.fill(0);
    for_each_key([&](const CodeKey& key, Counts& block) { ++block[digit(key, shift)]; });
    make_places(counts);
    for_each_key(
        [&](const CodeKey& key, Counts& block) { other[block[digit(key, shift)]++] = key; });
    keys.swap(other);
  }
}

}  // namespace spigolo
