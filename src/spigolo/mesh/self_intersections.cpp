// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/self_intersections.cpp - all pairs of triangles that run into each other
#include <algorithm>

#include "spigolo/core/parallel.h"
#include "spigolo/mesh/check.h"
#include "spigolo/mesh/triangle_contact.h"
#include "spigolo/mesh/triangle_tree.h"

namespace spigolo {
namespace {

constexpr std::size_t grain = 64;  // leaves
constexpr double least_height = 1e-6;

using Pairs = std::vector<std::array<std::uint32_t, 2>>;

class PairSearch {
 public:
  PairSearch(std::span<const Vec3> points, std::span<const Triangle> triangles,
             const TriangleTree& tree)
      : points_(points), triangles_(triangles), tree_(tree) {}

  // Pairs of a triangle of the leaf with one of the same or a later leaf.
  void of_leaf(std::size_t l, std::vector<std::uint32_t>& leaves, Pairs& found) const {
    tree_.overlapping(tree_.leaf_box(l), l, leaves);
    for (const std::uint32_t a : tree_.leaf(l))
      for (const std::uint32_t other : leaves) {
        if (!overlap(tree_.box(a), tree_.leaf_box(other))) continue;
        for (const std::uint32_t b : tree_.leaf(other))
          if ((other != l || b > a) && overlap(tree_.box(a), tree_.box(b)) && meet(a, b))
            found.push_back({std::min(a, b), std::max(a, b)});
      }
  }

 private:
  TrianglePoints corners(std::uint32_t t) const {
    const Triangle& v = triangles_[t];
    return {points_[v[0]], points_[v[1]], points_[v[2]]};
  }
  bool meet(std::uint32_t a, std::uint32_t b) const {
    return run_into_each_other(corners(a), corners(b));
  }

  std::span<const Vec3> points_;
  std::span<const Triangle> triangles_;
  const TriangleTree& tree_;
};

}  // namespace

bool is_degenerate(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double longest =
      std::max({squared_distance(a, b), squared_distance(b, c), squared_distance(c, a)});
  return !(norm(cross(b - a, c - a)) > least_height * longest);
}

Pairs find_self_intersections(std::span<const Vec3> points, std::span<const Triangle> triangles,
                              const Job& job) {
  std::vector<Triangle> sound;
  std::vector<std::uint32_t> number;
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const auto [a, b, c] = triangles[t];
    if (is_degenerate(points[a], points[b], points[c])) continue;
    sound.push_back(triangles[t]);
    number.push_back(t);
  }
  if (sound.empty()) return {};
  const TriangleTree tree(points, sound, job);
  const PairSearch search(points, sound, tree);
  std::vector<Pairs> per_range((tree.leaves() + grain - 1) / grain);
  parallel_for(job, "check", tree.leaves(), grain, [&](std::size_t begin, std::size_t end) {
    std::vector<std::uint32_t> leaves;
    for (std::size_t l = begin; l < end; ++l) search.of_leaf(l, leaves, per_range[begin / grain]);
  });
  Pairs all;
  for (const Pairs& pairs : per_range)
    for (const auto& [a, b] : pairs) all.push_back({number[a], number[b]});
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace spigolo
