// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/index/group_search.h - one vectorized search for a few points that lie together
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace spigolo {

/// Candidates of one group as floats in a frame of the group where all coordinates are within
/// [-1, 1]; arrays are padded with far-away points to full vectors.
struct GroupCandidates {
  std::size_t count = 0;
  std::vector<float> x, y, z;        // padded to padded_size()
  std::vector<std::uint32_t> index;  // ascending

  void clear() { count = 0; }
  void reserve(std::size_t n);
  static std::size_t padded(std::size_t n) {
    return (n + group_lanes - 1) / group_lanes * group_lanes;
  }

  static constexpr std::size_t group_lanes = 64;  // floats of the widest vector there may be
};

/// Scratch of one search: squared distances and the survivors' places in the candidate list.
struct GroupScratch {
  std::vector<float> squared_distance;
  std::vector<std::uint32_t> survivors;
};

/// Finds the places (ascending) of all candidates that can be among the `wanted` nearest to the
/// candidate at `query` (which counts itself): a superset, usually a few more than wanted.
/// threshold: in, a guess of the squared distance that holds them; out, the one used, with the
/// float rounding allowed for. Returns the number of survivors; less than wanted only if there are
/// not that many candidates.
std::size_t select_candidates(const GroupCandidates& candidates, std::size_t query,
                              std::size_t wanted, float& threshold, GroupScratch& scratch);

/// out[0..wanted) = places of the `wanted` smallest distances, ascending, ties by place; n <= 4096.
void rank_ascending(const double* distance, std::size_t n, std::size_t wanted, std::uint32_t* out);

}  // namespace spigolo
