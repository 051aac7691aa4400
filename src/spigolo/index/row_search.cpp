// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/index/row_search.cpp
#include "spigolo/index/row_search.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace spigolo {
namespace {

constexpr double first_reach = 1.3;           // of the first k-th neighbor that is known
constexpr double next_reach = 1.25;           // of the farthest one of the last group
constexpr std::size_t max_candidates = 1500;  // more are no longer cheaper than single searches

}  // namespace

// Candidates within reach_ of the group's box are enough for a query whose k-th neighbor is no
// farther than reach_; a query that needs more is searched by itself, and reach_ learns from it.
void RowSearch::find(std::span<const std::uint32_t> queries, std::uint32_t* rows) {
  Box box;
  for (const std::uint32_t q : queries) box.add(tree_.points()[q]);
  if (reach_ == 0) last_ = alone(queries.front(), rows), reach_ = first_reach * last_;
  const bool gathered = gather(box);
  double farthest = 0, nearest = infinity;
  float threshold = gathered ? static_cast<float>(last_ * last_ * scale_ * scale_) : 0.0f;
  std::size_t place = 0;
  for (const std::uint32_t q : queries) {
    double d = infinity;
    if (gathered) {
      place = place_of(q, place + 1);
      d = from_candidates(place, threshold, rows);
    }
    if (!(d <= reach_)) d = alone(q, rows);
    farthest = std::max(farthest, d);
    nearest = std::min(nearest, d);
    rows += k_;
  }
  last_ = nearest;
  reach_ = next_reach * farthest;
}

bool RowSearch::gather(const Box& box) {
  const auto nodes = tree_.nodes();
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
  return true;
}

// Into the group's frame, all coordinates within [-1, 1].
void RowSearch::load(const Box& group, std::size_t count) {
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

// Most often the one after the last.
std::size_t RowSearch::place_of(std::uint32_t point, std::size_t guess) const {
  if (guess < candidates_.count && candidates_.index[guess] == point) return guess;
  const auto first = candidates_.index.begin();
  return static_cast<std::size_t>(
      std::lower_bound(first, first + static_cast<std::ptrdiff_t>(candidates_.count), point) -
      first);
}

// Writes the row and returns the distance of its last neighbor.
double RowSearch::from_candidates(std::size_t place, float& threshold, std::uint32_t* row) {
  const std::size_t n = select_candidates(candidates_, place, k_ + 1, threshold, scratch_);
  if (n <= k_) return infinity;
  const std::uint32_t q = candidates_.index[place];
  exact_.resize(n);
  const Vec3 p = tree_.points()[q];
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t other = candidates_.index[scratch_.survivors[i]];
    // The point itself comes first: no other has a distance of less than zero.
    exact_[i] = other == q ? -1.0 : squared_distance(tree_.points()[other], p);
  }
  ranks_.resize(k_ + 1);
  rank_ascending(exact_.data(), n, k_ + 1, ranks_.data());
  for (std::size_t i = 0; i < k_; ++i)
    row[i] = candidates_.index[scratch_.survivors[ranks_[i + 1]]];
  return std::sqrt(exact_[ranks_[k_]]);
}

double RowSearch::alone(std::uint32_t point, std::uint32_t* row) {
  tree_.nearest(tree_.points()[point], k_ + 1, found_);
  // Where squared distances vanish, the point itself need not be among the nearest.
  std::uint32_t* const end = row + k_;
  for (const Neighbor& neighbor : found_)
    if (neighbor.index != point && row != end) *row++ = neighbor.index;
  return std::sqrt(found_.back().squared_distance);
}

}  // namespace spigolo
