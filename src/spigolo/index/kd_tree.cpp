// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/index/kd_tree.cpp
#include "spigolo/index/kd_tree.h"

#include <algorithm>
#include <array>
#include <bit>

namespace spigolo {
namespace {

constexpr std::uint32_t leaf_size = 8;
// A path halves a Morton cell at every step: 63 bits, then at most 32 halvings of equal codes.
constexpr std::size_t max_depth = 100;

// First place whose code has the highest bit that differs within the range; the middle if none
// does.
std::uint32_t split(std::span<const std::uint64_t> codes, std::uint32_t begin, std::uint32_t end) {
  const std::uint64_t differing = codes[begin] ^ codes[end - 1];
  if (differing == 0) return begin + (end - begin) / 2;
  const std::uint64_t bit = std::uint64_t{1} << (63 - std::countl_zero(differing));
  const auto first = codes.begin() + begin, last = codes.begin() + end;
  const auto it = std::partition_point(first, last, [&](std::uint64_t c) { return !(c & bit); });
  return begin + static_cast<std::uint32_t>(it - first);
}

double gap(double a_min, double a_max, double b_min, double b_max) {
  return std::max({0.0, a_min - b_max, b_min - a_max});
}

}  // namespace

double squared_distance(const Box& box, const Vec3& p) {
  const double x = gap(box.min.x, box.max.x, p.x, p.x), y = gap(box.min.y, box.max.y, p.y, p.y),
               z = gap(box.min.z, box.max.z, p.z, p.z);
  return x * x + y * y + z * z;
}

double squared_distance(const Box& a, const Box& b) {
  const double x = gap(a.min.x, a.max.x, b.min.x, b.max.x),
               y = gap(a.min.y, a.max.y, b.min.y, b.max.y),
               z = gap(a.min.z, a.max.z, b.min.z, b.max.z);
  return x * x + y * y + z * z;
}

KdTree::KdTree(const OrderedCloud& cloud) : points_(cloud.points) {
  if (points_.empty()) return;
  nodes_.reserve(points_.size() / 2 + 1);
  build(cloud.codes, 0, static_cast<std::uint32_t>(points_.size()));
}

std::uint32_t KdTree::build(std::span<const std::uint64_t> codes, std::uint32_t begin,
                            std::uint32_t end) {
  const auto id = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({{}, begin, end, 0});
  Box box;
  if (end - begin <= leaf_size) {
    for (std::uint32_t i = begin; i < end; ++i) box.add(points_[i]);
  } else {
    const std::uint32_t middle = split(codes, begin, end);
    const std::uint32_t left = build(codes, begin, middle), right = build(codes, middle, end);
    nodes_[id].right = right;
    for (const std::uint32_t child : {left, right}) {
      box.add(nodes_[child].box.min);
      box.add(nodes_[child].box.max);
    }
  }
  nodes_[id].box = box;
  return id;
}

void KdTree::nearest(const Vec3& query, std::size_t k, std::vector<Neighbor>& found) const {
  found.clear();
  if (nodes_.empty() || k == 0) return;
  struct Entry {
    std::uint32_t node;
    double squared_distance;
  };
  std::array<Entry, max_depth> stack;
  std::size_t depth = 0;
  stack[depth++] = {0, squared_distance(nodes_[0].box, query)};
  while (depth > 0) {
    const Entry entry = stack[--depth];
    if (found.size() == k && entry.squared_distance > found.front().squared_distance) continue;
    const Node& node = nodes_[entry.node];
    if (node.right != 0) {
      Entry near{entry.node + 1, squared_distance(nodes_[entry.node + 1].box, query)};
      Entry far{node.right, squared_distance(nodes_[node.right].box, query)};
      if (far.squared_distance < near.squared_distance) std::swap(near, far);
      stack[depth++] = far;
      stack[depth++] = near;
      continue;
    }
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
      const Neighbor candidate{squared_distance(points_[i], query), i};
      if (found.size() < k) {
        found.push_back(candidate);
        std::push_heap(found.begin(), found.end());
      } else if (candidate < found.front()) {
        std::pop_heap(found.begin(), found.end());
        found.back() = candidate;
        std::push_heap(found.begin(), found.end());
      }
    }
  }
  std::sort_heap(found.begin(), found.end());
}

void KdTree::within(const Vec3& query, double radius, std::vector<Neighbor>& found) const {
  found.clear();
  const double limit = radius * radius;
  std::array<std::uint32_t, max_depth> stack;
  std::size_t depth = 0;
  if (!nodes_.empty()) stack[depth++] = 0;
  while (depth > 0) {
    const std::uint32_t id = stack[--depth];
    const Node& node = nodes_[id];
    if (squared_distance(node.box, query) > limit) continue;
    if (node.right != 0) {
      stack[depth++] = node.right;
      stack[depth++] = id + 1;
      continue;
    }
    for (std::uint32_t i = node.begin; i < node.end; ++i)
      if (const double d = squared_distance(points_[i], query); d <= limit) found.push_back({d, i});
  }
}

}  // namespace spigolo
