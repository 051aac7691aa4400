// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/index/row_search.h - nearest neighbors of a few points that lie together, in one walk
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "spigolo/index/group_search.h"
#include "spigolo/index/kd_tree.h"

namespace spigolo {

/// Finds what KdTree::nearest finds, several times faster if the points lie together. Keeps its
/// memory between calls and learns from them how far to look: one for each thread. The tree must
/// outlive it.
class RowSearch {
 public:
  RowSearch(const KdTree& tree, std::size_t k) : tree_(tree), k_(k) {}  // k: below the tree's size

  /// rows[q * k] on: the k nearest neighbors of point queries[q], itself left out, nearest first,
  /// ties by the canonical order. queries: ascending, at least one.
  void find(std::span<const std::uint32_t> queries, std::uint32_t* rows);

 private:
  bool gather(const Box& box);
  void load(const Box& box, std::size_t count);
  std::size_t place_of(std::uint32_t point, std::size_t guess) const;
  double from_candidates(std::size_t place, float& threshold, std::uint32_t* row);
  double alone(std::uint32_t point, std::uint32_t* row);

  const KdTree& tree_;
  std::size_t k_;
  double reach_ = 0, last_ = 0, scale_ = 1;
  std::vector<std::uint32_t> leaves_, ranks_;
  std::vector<double> exact_;
  std::vector<Neighbor> found_;
  GroupCandidates candidates_;
  GroupScratch scratch_;
};

}  // namespace spigolo
