// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/measure/box_tree.cpp - a tree of boxes, split at the median of the longest side
#include "spigolo/measure/box_tree.h"

#include "spigolo/core/parallel.h"

namespace spigolo {
namespace {

constexpr std::uint32_t leaf_size = 8;
constexpr std::size_t part_size = 4096;  // of what one thread builds; fixed, so the tree is too
constexpr std::size_t grain = 65536;

void enclose(Box& box, const Box& other) {
  box.add(other.min);
  box.add(other.max);
}

}  // namespace

BoxTree::BoxTree(const std::vector<Box>& boxes, const Job& job) {
  std::vector<Entry> entries(boxes.size());
  parallel_for(job, "", boxes.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      entries[i] = {boxes[i].center(), static_cast<std::uint32_t>(i)};
  });
  // Level by level: the parts of one level are split at the same time.
  std::vector<Part> parts;
  parts.push_back({entries, 0, 0, {}});
  for (std::size_t level = 0; level < parts.size();) {
    const std::size_t next = parts.size();
    for (std::size_t p = level; p < next; ++p) {
      if (parts[p].entries.size() <= part_size) continue;
      parts[p].children = parts.size();
      const std::size_t half = parts[p].entries.size() / 2;
      const Part whole = parts[p];
      parts.push_back({whole.entries.first(half), whole.begin, 0, {}});
      parts.push_back(
          {whole.entries.subspan(half), whole.begin + static_cast<std::uint32_t>(half), 0, {}});
    }
    parallel_for(job, "", next - level, 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = level + begin; p < level + end; ++p) {
        if (parts[p].children > 0)
          split(parts[p].entries);
        else
          build(boxes, parts[p].entries, parts[p].begin, parts[p].nodes);
      }
    });
    level = next;
  }
  nodes_.reserve(boxes.size() / 2 + 1);
  join(parts, 0);
  items_.reserve(entries.size());
  for (const Entry& entry : entries) items_.push_back(entry.item);
}

/// Parts the entries at the median of their longest side; returns the size of the first part.
std::uint32_t BoxTree::split(std::span<Entry> entries) {
  Box centers;
  for (const Entry& entry : entries) centers.add(entry.center);
  const Vec3 spread = centers.size();
  const std::size_t axis = spread.x >= spread.y && spread.x >= spread.z ? 0
                           : spread.y >= spread.z                       ? 1
                                                                        : 2;
  const std::size_t half = entries.size() / 2;
  std::nth_element(entries.begin(), entries.begin() + static_cast<std::ptrdiff_t>(half),
                   entries.end(), [axis](const Entry& a, const Entry& b) {
                     const double x = a.center[axis], y = b.center[axis];
                     return x != y ? x < y : a.item < b.item;
                   });
  return static_cast<std::uint32_t>(half);
}

/// Builds the node of these entries, which become the slots from `begin` on; returns its index.
std::uint32_t BoxTree::build(const std::vector<Box>& boxes, std::span<Entry> entries,
                             std::uint32_t begin, std::vector<Node>& nodes) {
  const auto index = static_cast<std::uint32_t>(nodes.size());
  const auto size = static_cast<std::uint32_t>(entries.size());
  nodes.emplace_back();
  if (size <= leaf_size) {
    Box box;
    for (const Entry& entry : entries) enclose(box, boxes[entry.item]);
    nodes[index] = {box, begin, begin + size, 0};
    return index;
  }
  const std::uint32_t half = split(entries);
  const std::uint32_t left = build(boxes, entries.first(half), begin, nodes);
  const std::uint32_t right = build(boxes, entries.subspan(half), begin + half, nodes);
  Box box = nodes[left].box;
  enclose(box, nodes[right].box);
  nodes[index] = {box, 0, 0, right};
  return index;
}

/// Appends the subtree of a part; returns the index of its node.
std::uint32_t BoxTree::join(const std::vector<Part>& parts, std::size_t part) {
  const auto index = static_cast<std::uint32_t>(nodes_.size());
  const Part& p = parts[part];
  if (p.children == 0) {
    for (Node node : p.nodes) {
      if (node.right > 0) node.right += index;
      nodes_.push_back(node);
    }
    return index;
  }
  nodes_.emplace_back();
  const std::uint32_t left = join(parts, p.children), right = join(parts, p.children + 1);
  Box box = nodes_[left].box;
  enclose(box, nodes_[right].box);
  nodes_[index] = {box, 0, 0, right};
  return index;
}

}  // namespace spigolo
