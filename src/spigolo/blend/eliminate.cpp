// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/eliminate.cpp
#include "spigolo/blend/eliminate.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "spigolo/core/parallel.h"
#include "spigolo/index/kd_tree.h"

namespace spigolo {
namespace {

constexpr std::size_t grain = 256;
constexpr double largest_hole = 0.95;  // [spacings] from a candidate to the nearest that stays

// Twice the largest possible radius of discs at that density: the reach of the weight.
double reach_of(double spacing) { return 2 * spacing * std::sqrt(1 / (2 * std::sqrt(3.0))); }

// Distances below this share of the reach count as this: what is far too close is all the same, and
// the larger pattern decides (the paper's weight limiting).
double least_share(std::size_t candidates, std::size_t wanted) {
  const double kept = static_cast<double>(wanted) / static_cast<double>(candidates);
  return std::max(0.0, (1 - std::pow(kept, 1.5)) * 0.65);
}

struct Reach {
  double length = 0, least = 0;  // the weight ends at; distances below `least` count as this
};

// (1 - distance / reach)^8.
double crowding(double squared_distance, const Reach& reach) {
  const double d = std::max(std::sqrt(squared_distance), reach.least);
  const double share = 1 - d / reach.length;
  if (share <= 0) return 0;
  const double a = share * share, b = a * a;
  return b * b;
}

struct Link {
  std::uint32_t other;
  float weight;
};

// Who crowds whom, and by how much, all in canonical order.
struct Crowd {
  std::vector<std::uint64_t> begin;  // one more than candidates
  std::vector<Link> links;
  std::vector<double> weight;  // sum for each candidate
};

Crowd gather(const OrderedCloud& cloud, const Reach& reach, const FixedPoints& fixed,
             const Job& job) {
  const KdTree tree(cloud);
  const std::size_t n = cloud.size();
  std::vector<std::vector<Link>> rows((n + grain - 1) / grain);
  Crowd crowd;
  crowd.begin.assign(n + 1, 0);
  crowd.weight.assign(n, 0);
  parallel_for(job, "thinning: neighbors", rows.size(), 1, [&](std::size_t from, std::size_t to) {
    std::vector<Neighbor> found;
    for (std::size_t block = from; block < to; ++block)
      for (std::size_t i = block * grain; i < std::min(n, (block + 1) * grain); ++i) {
        tree.within(cloud.points[i], reach.length, found);
        double sum = 0;
        for (const Neighbor& other : found) {
          if (other.index == i) continue;
          const auto w = static_cast<float>(crowding(other.squared_distance, reach));
          rows[block].push_back({other.index, w});
          sum += double{w};
        }
        crowd.begin[i + 1] = found.size() - 1;
        fixed(cloud.points[i] + cloud.origin, reach.length,
              [&](double squared) { sum += crowding(squared, reach); });
        crowd.weight[i] = sum;
      }
  });
  std::partial_sum(crowd.begin.begin(), crowd.begin.end(), crowd.begin.begin());
  crowd.links.reserve(crowd.begin.back());
  for (const auto& row : rows) crowd.links.insert(crowd.links.end(), row.begin(), row.end());
  return crowd;
}

// The most crowded candidate on top; of equal ones the first in canonical order.
class Heap {
 public:
  explicit Heap(std::vector<double>& weight)
      : weight_(weight), order_(weight.size()), place_(weight.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    std::iota(place_.begin(), place_.end(), 0u);
    for (std::size_t i = order_.size() / 2; i-- > 0;) sink(i);
  }
  std::size_t size() const { return order_.size(); }
  bool holds(std::uint32_t i) const { return place_[i] != gone; }

  std::uint32_t pop() {
    const std::uint32_t top = order_.front();
    place_[top] = gone;
    const std::uint32_t last = order_.back();
    order_.pop_back();
    if (!order_.empty()) {
      put(0, last);
      sink(0);
    }
    return top;
  }
  /// Its weight has become less.
  void lightened(std::uint32_t i) { sink(place_[i]); }

 private:
  static constexpr std::uint32_t gone = 0xffffffffu;

  bool above(std::uint32_t a, std::uint32_t b) const {
    return weight_[a] != weight_[b] ? weight_[a] > weight_[b] : a < b;
  }
  void put(std::size_t at, std::uint32_t i) {
    order_[at] = i;
    place_[i] = static_cast<std::uint32_t>(at);
  }
  void sink(std::size_t at) {
    const std::uint32_t i = order_[at];
    for (std::size_t child = 2 * at + 1; child < order_.size(); child = 2 * at + 1) {
      if (child + 1 < order_.size() && above(order_[child + 1], order_[child])) ++child;
      if (!above(order_[child], i)) break;
      put(at, order_[child]);
      at = child;
    }
    put(at, i);
  }

  std::vector<double>& weight_;
  std::vector<std::uint32_t> order_, place_;
};

// Candidates in places that have become too empty come back, the first in canonical order first.
void fill_holes(const OrderedCloud& cloud, const Crowd& crowd, double largest,
                const FixedPoints& fixed, std::vector<char>& kept) {
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (kept[i]) continue;
    bool covered = false;
    for (std::uint64_t k = crowd.begin[i]; k < crowd.begin[i + 1] && !covered; ++k) {
      const std::uint32_t other = crowd.links[k].other;
      covered = kept[other] &&
                squared_distance(cloud.points[i], cloud.points[other]) <= largest * largest;
    }
    if (!covered) fixed(cloud.points[i] + cloud.origin, largest, [&](double) { covered = true; });
    if (!covered) kept[i] = 1;
  }
}

}  // namespace

std::vector<char> eliminate(std::span<const Vec3> candidates, std::size_t wanted, double spacing,
                            const FixedPoints& fixed, const Job& job) {
  std::vector<char> stays(candidates.size(), 0);
  if (candidates.empty()) return stays;
  const OrderedCloud cloud = order_cloud(candidates, job);
  const double length = reach_of(spacing);
  Crowd crowd = gather(cloud, {length, length * least_share(cloud.size(), wanted)}, fixed, job);
  Heap heap(crowd.weight);
  while (heap.size() > wanted) {
    if ((heap.size() & 0xfff) == 0) job.check();
    const std::uint32_t out = heap.pop();
    for (std::uint64_t k = crowd.begin[out]; k < crowd.begin[out + 1]; ++k) {
      const Link& link = crowd.links[k];
      if (!heap.holds(link.other)) continue;
      crowd.weight[link.other] -= double{link.weight};
      heap.lightened(link.other);
    }
  }
  std::vector<char> kept(cloud.size());
  for (std::uint32_t i = 0; i < kept.size(); ++i) kept[i] = heap.holds(i);
  fill_holes(cloud, crowd, largest_hole * spacing, fixed, kept);
  std::vector<char> first_there(cloud.size(), 1);  // of candidates in one place only one stays
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const std::uint32_t at = cloud.rank[i];
    if (at == no_point || !kept[at] || !first_there[at]) continue;
    first_there[at] = 0;
    stays[i] = 1;
  }
  return stays;
}

}  // namespace spigolo
