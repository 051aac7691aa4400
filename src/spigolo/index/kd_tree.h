// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/index/kd_tree.h - exact nearest neighbors, ties by the canonical order
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "spigolo/core/geometry.h"
#include "spigolo/index/order.h"

namespace spigolo {

/// A found point: its place in the canonical order and its squared distance.
struct Neighbor {
  double squared_distance = 0;
  std::uint32_t index = 0;

  friend bool operator<(const Neighbor& a, const Neighbor& b) {
    return a.squared_distance != b.squared_distance ? a.squared_distance < b.squared_distance
                                                    : a.index < b.index;
  }
};

/// A kd-tree (thesis §3.4.1) over an ordered cloud: cells are halved along x, y, z in turn, which
/// is how the Morton curve already sorts them, so building it only measures boxes. The cloud must
/// outlive the tree and stay unchanged.
class KdTree {
 public:
  struct Node {
    Box box;                  // of the points in it
    std::uint32_t begin = 0;  // points [begin, end) of the canonical order
    std::uint32_t end = 0;
    std::uint32_t right = 0;  // its right child; the left one follows the node; 0 for a leaf
  };

  explicit KdTree(const OrderedCloud& cloud);

  std::span<const Vec3> points() const { return points_; }
  std::span<const Node> nodes() const { return nodes_; }

  /// The min(k, size) points nearest to query, nearest first, ties by the canonical order. query is
  /// relative to the cloud's origin and need not be a point of the cloud; one that is finds itself.
  /// `found` is overwritten; keeping it between calls avoids allocation.
  void nearest(const Vec3& query, std::size_t k, std::vector<Neighbor>& found) const;

  /// All points within radius (inclusive), in the canonical order.
  void within(const Vec3& query, double radius, std::vector<Neighbor>& found) const;

 private:
  std::uint32_t build(std::span<const std::uint64_t> codes, std::uint32_t begin, std::uint32_t end);

  std::span<const Vec3> points_;
  std::vector<Node> nodes_;
};

/// Squared distance from a point to a box, 0 inside.
double squared_distance(const Box& box, const Vec3& p);

/// Squared distance between two boxes, 0 if they touch.
double squared_distance(const Box& a, const Box& b);

}  // namespace spigolo
