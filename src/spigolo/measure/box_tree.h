// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/measure/box_tree.h - the nearest of many things with boxes
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "spigolo/core/geometry.h"
#include "spigolo/core/job.h"

namespace spigolo {

/// A tree of boxes over items 0, 1, ... Ties in distance go to the smaller item.
class BoxTree {
 public:
  /// One box per item, none empty; at least one. The same tree for any number of threads.
  explicit BoxTree(const std::vector<Box>& boxes, const Job& job = {});

  /// The items as the tree holds them: slot i has item items()[i]. Data kept in this order is read
  /// in one piece.
  const std::vector<std::uint32_t>& items() const { return items_; }

  struct Nearest {
    std::size_t slot = 0;
    double squared_distance = infinity;
  };

  /// squared_distance(slot): of the slot's item to p, not less than that of its box.
  template <class F>
  Nearest nearest(const Vec3& p, const F& squared_distance) const;

 private:
  struct Node {
    Box box;
    std::uint32_t begin = 0, end = 0;  // slots of a leaf; else begin = end
    std::uint32_t right = 0;           // second child; the first one follows the node
  };
  struct Entry {
    Vec3 center;
    std::uint32_t item;
  };
  // Entries that become one subtree: split into two parts, or built by one thread.
  struct Part {
    std::span<Entry> entries;
    std::uint32_t begin = 0;   // first slot
    std::size_t children = 0;  // the first of two; 0: not split
    std::vector<Node> nodes;
  };
  static std::uint32_t split(std::span<Entry> entries);
  static std::uint32_t build(const std::vector<Box>& boxes, std::span<Entry> entries,
                             std::uint32_t begin, std::vector<Node>& nodes);
  std::uint32_t join(const std::vector<Part>& parts, std::size_t part);

  std::vector<std::uint32_t> items_;
  std::vector<Node> nodes_;
};

/// Squared distance of p to the box, 0 inside.
inline double box_squared_distance(const Box& box, const Vec3& p) {
  auto gap = [](double low, double high, double x) { return std::max({low - x, x - high, 0.0}); };
  return squared_norm({gap(box.min.x, box.max.x, p.x), gap(box.min.y, box.max.y, p.y),
                       gap(box.min.z, box.max.z, p.z)});
}

template <class F>
BoxTree::Nearest BoxTree::nearest(const Vec3& p, const F& squared_distance) const {
  struct Pending {
    std::uint32_t node;
    double bound;
  };
  Pending stack[64];  // one entry per level, of at most 33
  int top = 0;
  stack[top++] = {0, box_squared_distance(nodes_[0].box, p)};
  Nearest best;
  while (top > 0) {
    const auto [index, bound] = stack[--top];
    if (bound > best.squared_distance) continue;
    const Node& node = nodes_[index];
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      const double d = squared_distance(std::size_t{i});
      const bool tie = d == best.squared_distance && items_[i] < items_[best.slot];
      if (d < best.squared_distance || tie) best = {i, d};
    }
    if (node.begin < node.end) continue;
    Pending near{index + 1, box_squared_distance(nodes_[index + 1].box, p)};
    Pending far{node.right, box_squared_distance(nodes_[node.right].box, p)};
    if (far.bound < near.bound) std::swap(near, far);
    stack[top++] = far;
    stack[top++] = near;
  }
  return best;
}

}  // namespace spigolo
