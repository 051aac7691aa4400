// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/triangle_tree.h - which triangles of a mesh come near each other
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "spigolo/core/geometry.h"
#include "spigolo/core/job.h"
#include "spigolo/mesh/edges.h"

namespace spigolo {

/// A complete binary tree of boxes over the triangles along a Morton curve, eight in a leaf.
class TriangleTree {
 public:
  /// At least one triangle; points are finite.
  TriangleTree(std::span<const Vec3> points, std::span<const Triangle> triangles, const Job& job);

  static constexpr std::size_t leaf_size = 8;
  std::size_t leaves() const { return leaves_; }
  /// The triangles of a leaf.
  std::span<const std::uint32_t> leaf(std::size_t l) const;
  const Box& box(std::uint32_t triangle) const { return boxes_[triangle]; }
  const Box& leaf_box(std::size_t l) const { return nodes_[width_ - 1 + l]; }

  /// The leaves whose boxes meet the given one, ascending, from `first` on.
  void overlapping(const Box& box, std::size_t first, std::vector<std::uint32_t>& found) const;

 private:
  std::size_t leaves_ = 0, width_ = 1;  // width: power of two that holds the leaves
  std::vector<std::uint32_t> order_;
  std::vector<Box> boxes_;  // per triangle
  std::vector<Box> nodes_;  // heap order; leaves last
};

/// Whether two closed boxes have a point in common.
bool overlap(const Box& a, const Box& b);

}  // namespace spigolo
