// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/gauss_map/edges.h - the vectors from a point to its neighbors, as the vector units read
// them
#pragma once

#include <array>
#include <cstddef>

namespace spigolo {

/// Unit vectors along p_i - p, padded so that a full vector can be read from any of them.
struct Edges {
  static constexpr std::size_t most = 64;
  static constexpr std::size_t widest_vector = 64;  // floats
  std::array<float, most + widest_vector> x{}, y{}, z{};
};

}  // namespace spigolo
