// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/index/neighborhoods.cpp - points that lie together share one walk through the tree
#include "spigolo/index/neighborhoods.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "spigolo/core/error.h"
#include "spigolo/core/parallel.h"
#include "spigolo/index/group_search.h"

namespace spigolo {
namespace {

constexpr std::uint32_t group_size = 16;      // queries that share their candidates
constexpr double first_reach = 1.3;           // of the first k-th neighbor that is known
constexpr double next_reach = 1.25;           // of the farthest one of the last group
constexpr std::size_t max_candidates = 1500;  // more are no longer cheaper than single searches
constexpr std::size_t grain = 128;            // groups handed to a thread at a time

struct Group {
  std::uint32_t node, begin, end;
};

// The largest cells of the tree with at most group_size points.
std::vector<Group> make_groups(const KdTree& tree) {
  std::vector<Group> groups;
  const auto nodes = tree.nodes();
  for (std::uint32_t id = 0; id < nodes.size();) {
    const KdTree::Node& node = nodes[id];
    if (node.end - node.begin > group_size && node.right != 0) {
      ++id;  // its left child follows, the right one after that
      continue;
    }
    groups.push_back({id, node.begin, node.end});
    while (id < nodes.size() && nodes[id].begin < node.end) ++id;  // over all its children
  }
  return groups;
}

class Searcher {
 public:
  Searcher(const KdTree& tree, std::size_t k, Neighborhoods& result)
      : tree_(tree), k_(k), result_(result) {}

  // Candidates within reach_ of the group's box are enough for a query whose k-th neighbor is no
  // farther than reach_; a query that needs more is searched by itself, and reach_ learns from it.
  void search(const Group& group) {
    if (reach_ == 0) last_ = alone(group.begin), reach_ = first_reach * last_;
    const bool gathered = gather(group);
    double farthest = 0, nearest = infinity;
    float threshold = gathered ? static_cast<float>(last_ * last_ * scale_ * scale_) : 0.0f;
    for (std::uint32_t q = group.begin; q < group.end; ++q) {
      double d = gathered ? from_candidates(q, threshold) : infinity;
      if (!(d <= reach_)) d = alone(q);
      farthest = std::max(farthest, d);
      nearest = std::min(nearest, d);
    }
    last_ = nearest;
    reach_ = next_reach * farthest;
  }

 private:
  bool gather(const Group& group) {
    const auto nodes = tree_.nodes();
    const Box& box = nodes[group.node].box;
    const double limit = reach_ * reach_ * (1 + 1e-12);  // what rounds to reach_ is gathered too
    leaves_.clear();
    std::size_t count = 0, depth = 0;
    std::array<std::uint32_t, 128> stack;
    stack[depth++] = 0;
    while (depth > 0) {
      const std::uint32_t id = stack[--depth];
      const KdTree::Node& node = nodes[id];
      if (squared_distance(node.box, box) > limit) continue;
      if (node.right != 0) {
        stack[depth++] = node.right;
        stack[depth++] = id + 1;
        continue;
      }
      leaves_.push_back(id);
      count += node.end - node.begin;
      if (count > max_candidates) return false;
    }
    if (count <= k_) return false;
    load(box, count);
    first_ = place_of(group.begin);
    return true;
  }

  // Into the group's frame, all coordinates within [-1, 1].
  void load(const Box& group, std::size_t count) {
    const Vec3 center = group.center(), size = group.size();
    double extent = std::max({size.x, size.y, size.z}) / 2 + reach_;
    Box all;
    for (const std::uint32_t id : leaves_) {
      all.add(tree_.nodes()[id].box.min);
      all.add(tree_.nodes()[id].box.max);
    }
    for (const Vec3& v : {all.max - center, center - all.min})
      extent = std::max({extent, v.x, v.y, v.z});
    scale_ = 1 / extent;
    candidates_.reserve(count);
    std::size_t n = 0;
    for (const std::uint32_t id : leaves_) {
      for (std::uint32_t i = tree_.nodes()[id].begin; i < tree_.nodes()[id].end; ++i, ++n) {
        const Vec3 p = (tree_.points()[i] - center) * scale_;
        candidates_.x[n] = static_cast<float>(p.x);
        candidates_.y[n] = static_cast<float>(p.y);
        candidates_.z[n] = static_cast<float>(p.z);
        candidates_.index[n] = i;
      }
    }
    candidates_.count = n;
    for (; n < GroupCandidates::padded(count); ++n)
      candidates_.x[n] = candidates_.y[n] = candidates_.z[n] = 1e9f;
  }

  std::size_t place_of(std::uint32_t point) const {
    const auto first = candidates_.index.begin();
    return static_cast<std::size_t>(
        std::lower_bound(first, first + static_cast<std::ptrdiff_t>(candidates_.count), point) -
        first);
  }

  // Writes row q and returns the distance of its last neighbor.
  double from_candidates(std::uint32_t q, float& threshold) {
    const std::size_t query = first_ + (q - begin_of_group());
    const std::size_t n = select_candidates(candidates_, query, k_ + 1, threshold, scratch_);
    if (n <= k_) return infinity;
    exact_.resize(n);
    const Vec3 p = tree_.points()[q];
    for (std::size_t i = 0; i < n; ++i) {
      const std::uint32_t other = candidates_.index[scratch_.survivors[i]];
      // The point itself comes first: no other has a distance of less than zero.
      exact_[i] = other == q ? -1.0 : squared_distance(tree_.points()[other], p);
    }
    ranks_.resize(k_ + 1);
    rank_ascending(exact_.data(), n, k_ + 1, ranks_.data());
    std::uint32_t* row = result_.index.data() + std::size_t{q} * k_;
    for (std::size_t i = 0; i < k_; ++i)
      row[i] = candidates_.index[scratch_.survivors[ranks_[i + 1]]];
    return std::sqrt(exact_[ranks_[k_]]);
  }

  std::uint32_t begin_of_group() const { return candidates_.index[first_]; }

  double alone(std::uint32_t q) {
    tree_.nearest(tree_.points()[q], k_ + 1, found_);
    std::uint32_t* row = result_.index.data() + std::size_t{q} * k_;
    for (const Neighbor& neighbor : found_)
      if (neighbor.index != q) *row++ = neighbor.index;
    return std::sqrt(found_.back().squared_distance);
  }

  const KdTree& tree_;
  std::size_t k_;
  Neighborhoods& result_;
  double reach_ = 0, last_ = 0, scale_ = 1;
  std::size_t first_ = 0;  // place of the group's first point among the candidates
  std::vector<std::uint32_t> leaves_, ranks_;
  std::vector<double> exact_;
  std::vector<Neighbor> found_;
  GroupCandidates candidates_;
  GroupScratch scratch_;
};

}  // namespace

Neighborhoods find_neighborhoods(const KdTree& tree, std::size_t k, const Job& job) {
  Neighborhoods result;
  const std::size_t n = tree.points().size();
  result.k = n == 0 ? 0 : std::min(k, n - 1);
  if (result.k == 0) return result;
  result.index = parallel_array<std::uint32_t>(job, n * result.k);
  const std::vector<Group> groups = make_groups(tree);
  parallel_for(job, "neighbors", groups.size(), grain, [&](std::size_t begin, std::size_t end) {
    Searcher searcher(tree, result.k, result);
    for (std::size_t g = begin; g < end; ++g) searcher.search(groups[g]);
  });
  return result;
}

void validate(const Neighborhoods& neighborhoods, std::span<const Vec3> points) {
  if (neighborhoods.size() != points.size() && neighborhoods.k != 0)
    throw Error("neighborhoods: one row a point is needed");
  std::vector<std::uint32_t> sorted;
  for (std::size_t i = 0; i < neighborhoods.size(); ++i) {
    const auto row = neighborhoods.of(i);
    sorted.assign(row.begin(), row.end());
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
      throw Error("neighborhoods: a neighbor stands twice");
    double last = 0;
    for (const std::uint32_t j : row) {
      if (j >= points.size() || j == i) throw Error("neighborhoods: not a neighbor");
      const double d = squared_distance(points[i], points[j]);
      if (d < last) throw Error("neighborhoods: not nearest first");
      last = d;
    }
  }
}

}  // namespace spigolo
