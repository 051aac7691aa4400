// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/measure/box_tree.cpp - a tree of boxes, split at the median of the longest side
#include "spigolo/measure/box_tree.h"

namespace spigolo {
namespace {

constexpr std::uint32_t leaf_size = 8;

void enclose(Box& box, const Box& other) {
  box.add(other.min);
  box.add(other.max);
}

}  // namespace

BoxTree::BoxTree(const std::vector<Box>& boxes) {
  std::vector<Entry> entries(boxes.size());
  for (std::uint32_t i = 0; i < boxes.size(); ++i) entries[i] = {boxes[i].center(), i};
  nodes_.reserve(boxes.size() / 2 + 1);
  build(boxes, entries, 0);
  items_.reserve(entries.size());
  for (const Entry& entry : entries) items_.push_back(entry.item);
}

/// Builds the node of these entries, which become the slots from `begin` on; returns its index.
std::uint32_t BoxTree::build(const std::vector<Box>& boxes, std::span<Entry> entries,
                             std::uint32_t begin) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  const auto size = static_cast<std::uint32_t>(entries.size());
  nodes_.emplace_back();
  if (size <= leaf_size) {
    Box box;
    for (const Entry& entry : entries) enclose(box, boxes[entry.item]);
    nodes_[index] = {box, begin, begin + size, 0};
    return index;
  }
  Box centers;
  for (const Entry& entry : entries) centers.add(entry.center);
  const Vec3 spread = centers.size();
  const std::size_t axis = spread.x >= spread.y && spread.x >= spread.z ? 0
                           : spread.y >= spread.z                       ? 1
                                                                        : 2;
  const std::uint32_t half = size / 2;
  std::nth_element(entries.begin(), entries.begin() + half, entries.end(),
                   [axis](const Entry& a, const Entry& b) {
                     const double x = a.center[axis], y = b.center[axis];
                     return x != y ? x < y : a.item < b.item;
                   });
  const std::uint32_t left = build(boxes, entries.first(half), begin);
  const std::uint32_t right = build(boxes, entries.subspan(half), begin + half);
  Box box = nodes_[left].box;
  enclose(box, nodes_[right].box);
  nodes_[index] = {box, 0, 0, right};
  return index;
}

}  // namespace spigolo
