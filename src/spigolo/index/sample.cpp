// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/index/sample.cpp
#include "spigolo/index/sample.h"

#include <algorithm>
#include <cmath>

namespace spigolo {
namespace {

constexpr double alike = 1e-6;  // of the cloud's spacing: what rounding may change
constexpr std::uint64_t golden = 0x9e3779b97f4a7c15u;  // Knuth's multiplicative hash
constexpr double too_few = 0.5, too_many = 1.5;        // of what was asked

}  // namespace

std::uint32_t chance_number(const Spacing& spacing, std::size_t i) {
  const auto key = std::llround(spacing.of_point[i] / (alike * spacing.of_cloud));
  return static_cast<std::uint32_t>(static_cast<std::uint64_t>(key) * golden >> 32);
}

std::vector<std::uint32_t> sample_points(const Spacing& spacing, std::size_t asked) {
  const std::size_t n = spacing.of_point.size();
  std::vector<std::uint32_t> sample;
  if (asked < n && spacing.of_cloud > 0) {
    const double share = static_cast<double>(asked) / static_cast<double>(n);
    const auto limit = static_cast<std::uint32_t>(share * 4294967295.0);
    for (std::uint32_t i = 0; i < n; ++i)
      if (chance_number(spacing, i) < limit) sample.push_back(i);
    const double found = static_cast<double>(sample.size()), of = static_cast<double>(asked);
    if (found >= too_few * of && found <= too_many * of) return sample;
    sample.clear();
  }
  asked = std::min(asked, n);
  for (std::size_t look = 0; look < asked; ++look)
    sample.push_back(static_cast<std::uint32_t>(look * n / asked));
  return sample;
}

}  // namespace spigolo
