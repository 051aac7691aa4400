// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/triangle_tree.cpp
#include "spigolo/mesh/triangle_tree.h"

#include <algorithm>
#include <array>

#include "spigolo/core/parallel.h"

namespace spigolo {
namespace {

constexpr std::size_t grain = 4096;
constexpr double cells = 1 << 21;

// Every third bit.
std::uint64_t spread(std::uint64_t x) {
  x &= 0x1fffff;
  x = (x | x << 32) & 0x1f00000000ffff;
  x = (x | x << 16) & 0x1f0000ff0000ff;
  x = (x | x << 8) & 0x100f00f00f00f00f;
  x = (x | x << 4) & 0x10c30c30c30c30c3;
  return (x | x << 2) & 0x1249249249249249;
}

std::uint64_t morton(const Vec3& p, const Box& bounds) {
  const Vec3 size = bounds.size();
  const double scale = cells / std::max({size.x, size.y, size.z, 1e-300});
  std::uint64_t code = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double x = std::clamp((p[axis] - bounds.min[axis]) * scale, 0.0, cells - 1);
    code |= spread(static_cast<std::uint64_t>(x)) << axis;
  }
  return code;
}

void enclose(Box& box, const Box& other) {
  if (other.empty()) return;
  box.add(other.min);
  box.add(other.max);
}

}  // namespace

bool overlap(const Box& a, const Box& b) {
  return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y &&
         a.min.z <= b.max.z && b.min.z <= a.max.z;
}

TriangleTree::TriangleTree(std::span<const Vec3> points, std::span<const Triangle> triangles,
                           const Job& job)
    : boxes_(triangles.size()) {
  const Box bounds = bounding_box(points);
  std::vector<std::pair<std::uint64_t, std::uint32_t>> codes(triangles.size());
  parallel_for(job, "", triangles.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      for (const std::uint32_t v : triangles[t]) boxes_[t].add(points[v]);
      codes[t] = {morton(boxes_[t].center(), bounds), static_cast<std::uint32_t>(t)};
    }
  });
  std::sort(codes.begin(), codes.end());
  order_.reserve(codes.size());
  for (const auto& [code, t] : codes) order_.push_back(t);
  leaves_ = (order_.size() + leaf_size - 1) / leaf_size;
  while (width_ < leaves_) width_ *= 2;
  nodes_.resize(2 * width_ - 1);
  for (std::size_t l = 0; l < leaves_; ++l)
    for (const std::uint32_t t : leaf(l)) enclose(nodes_[width_ - 1 + l], boxes_[t]);
  for (std::size_t i = width_ - 1; i-- > 0;) {
    enclose(nodes_[i], nodes_[2 * i + 1]);
    enclose(nodes_[i], nodes_[2 * i + 2]);
  }
}

std::span<const std::uint32_t> TriangleTree::leaf(std::size_t l) const {
  const std::size_t begin = l * leaf_size;
  return {order_.data() + begin, std::min(leaf_size, order_.size() - begin)};
}

void TriangleTree::overlapping(const Box& box, std::size_t first,
                               std::vector<std::uint32_t>& found) const {
  found.clear();
  struct Pending {
    std::size_t node, end;  // one past the last leaf below it
    std::size_t size;       // leaves below it
  };
  std::array<Pending, 40> stack;
  std::size_t top = 0;
  stack[top++] = {0, width_, width_};
  while (top > 0) {
    const Pending p = stack[--top];
    if (p.end <= first || nodes_[p.node].empty() || !overlap(box, nodes_[p.node])) continue;
    if (p.size == 1) {
      found.push_back(static_cast<std::uint32_t>(p.end - 1));
      continue;
    }
    const std::size_t half = p.size / 2;
    stack[top++] = {2 * p.node + 2, p.end, half};
    stack[top++] = {2 * p.node + 1, p.end - half, half};
  }
}

}  // namespace spigolo
