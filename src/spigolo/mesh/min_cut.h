// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/min_cut.h - two labels at the least cost
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "spigolo/core/job.h"

namespace spigolo {

/// Nodes are labelled 0 or 1 such that the sum of the prices is least. Prices are whole numbers,
/// so the result is exact; their sum at one node must stay below 2^31.
class MinCut {
 public:
  explicit MinCut(std::size_t nodes);

  /// What labels 0 and 1 of a node cost, >= 0; adds to what was said before.
  void add_node_price(std::uint32_t node, std::int32_t of_0, std::int32_t of_1);
  /// What it costs that two nodes have different labels, >= 0.
  void add_edge_price(std::uint32_t a, std::uint32_t b, std::int32_t price);

  /// One label a node; of several best labellings the one with most 1s. Ends the use of the object.
  /// Throws Cancelled.
  std::vector<std::uint8_t> solve(const Job& job = {});

 private:
  static constexpr std::uint32_t none = 0xffffffffu, root = none - 1, orphan = none - 2;
  enum class Tree : std::uint8_t { free, zero, one };

  // Arc 2 e runs from its tail to its head, arc 2 e + 1 back.
  struct Arc {
    std::uint32_t head, next;
    std::int32_t left;  // capacity
  };
  struct Node {
    std::uint32_t first = none;   // arc
    std::uint32_t parent = none;  // arc from here towards the root of the tree
    std::int32_t terminal = 0;    // capacity left from the root of tree 0; of tree 1 if negative
    std::uint32_t seen = 0;       // round in which `steps` was right
    std::uint32_t steps = 0;      // to the root
    Tree tree = Tree::free;
    bool active = false;
  };

  void activate(std::uint32_t node);
  std::uint32_t grow(std::uint32_t node);  // the arc that joins the trees, or none
  void augment(std::uint32_t arc);
  std::int32_t bottleneck(std::uint32_t node, bool towards) const;
  void push(std::uint32_t node, bool towards, std::int32_t flow);
  void adopt();
  void find_parent(std::uint32_t node);
  std::uint32_t steps_to_root(std::uint32_t node);
  /// Capacity left along tree direction: into `node` for tree 0, out of it for tree 1.
  std::int32_t left_from(std::uint32_t arc_of_node, Tree tree) const {
    return tree == Tree::zero ? arcs_[arc_of_node ^ 1].left : arcs_[arc_of_node].left;
  }

  std::vector<Node> nodes_;
  std::vector<Arc> arcs_;
  std::vector<std::uint32_t> queue_, orphans_;
  std::size_t queue_head_ = 0;
  std::uint32_t round_ = 0;
};

}  // namespace spigolo
