// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/recut.cpp
#include "spigolo/mesh/recut.h"

#include <algorithm>
#include <unordered_map>

#include "spigolo/core/parity_sets.h"
#include "spigolo/mesh/min_cut.h"
#include "spigolo/mesh/openness.h"

namespace spigolo {
namespace {

const double flat_enough = radians(20);  // facets tilted less against the sheets cost no more
const double too_steep = radians(50);    // facets tilted more cost the most
const double doubtful = radians(40);     // a facet of the surface tilted more is looked at again
constexpr double price_of_area = 0.1;    // against 1 for a facet that is too steep
constexpr double price_of_belief = 1.5;  // about the area of a facet that is too steep
constexpr double unit = 10000;           // prices are whole numbers of 1 / unit
constexpr double dearest = 1000;         // no price is higher: their sums stay whole numbers
constexpr double largest_leak = 8;       // [steps] across; wider ones may be openings
constexpr double share_of_hull = 0.3;    // a flat sheet has half of its hull below
constexpr double along_sheets = 0.35;    // price of an area; one square to the sheets costs 1.1
constexpr int rings = 3;                 // around doubtful tetrahedra that may change

class Recut {
 public:
  Recut(const Delaunay& delaunay, const MeshSamples& samples, const CreaseSides& sides,
        Labelling& labels)
      : tets_(delaunay.tetrahedra()),
        samples_(samples),
        openness_(delaunay, samples, sides),
        labels_(labels),
        node_(tets_.size(), no_index) {}

  std::size_t run(const Job& job) {
    close_leaks();
    find_region(job);
    if (count_ == 0) return 0;
    MinCut cut(count_);
    add_facets(cut);
    for (const Belief& belief : labels_.beliefs) {
      const std::uint32_t node = node_[belief.tetrahedron];
      const std::int32_t price = whole(price_of_belief);
      if (node != no_index)
        cut.add_node_price(node, belief.inside ? price : 0, belief.inside ? 0 : price);
    }
    const std::vector<std::uint8_t> inside = cut.solve(job);
    std::size_t changed = 0;
    for (std::size_t t = 0; t < tets_.size(); ++t) {
      if (node_[t] == no_index) continue;
      changed += labels_.inside[t] != inside[node_[t]];
      labels_.inside[t] = inside[node_[t]];
    }
    return changed;
  }

 private:
  static std::int32_t whole(double price) {
    return static_cast<std::int32_t>(std::min(price, dearest) * unit + 0.5);
  }

  bool at_helper(std::uint32_t t) const {
    return *std::min_element(tets_[t].v.begin(), tets_[t].v.end()) < Delaunay::helpers;
  }

  // False for facets at the helpers.
  bool corners_of(std::uint32_t t, std::size_t i, Triangle& corners) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = tets_[t].v[facet_corners[i][k]];
      if (v < Delaunay::helpers) return false;
      corners[k] = v - Delaunay::helpers;
    }
    return true;
  }

  double area(const Triangle& corners) const {
    const Vec3 &a = samples_.position[corners[0]], &b = samples_.position[corners[1]],
               &c = samples_.position[corners[2]];
    const double length = samples_.length[corners[0]];
    return norm(cross(b - a, c - a)) / (2 * length * length);
  }

  double price(const Triangle& corners) const {
    const double steep = (openness_.tilt(corners) - flat_enough) / (too_steep - flat_enough);
    return area(corners) * (price_of_area + std::clamp(steep, 0.0, 1.0));
  }

  // A part of the inside that reaches the helpers, and its share of the hull of all samples.
  struct Leak {
    Box box;
    double area = 0, price = 0;
  };

  // Such parts are openings of the surface where they are wide. Small ones are mistakes, and so are
  // those whose hull runs along the sheets, but for sheets that are all hull.
  bool is_mistake(const Leak& leak, double hull) const {
    return norm(leak.box.size()) <= largest_leak * samples_.step ||
           (leak.area < share_of_hull * hull && leak.price < along_sheets * leak.area);
  }

  bool leaks(std::uint32_t t) const {
    return t != no_index && tets_[t].alive() && labels_.inside[t] && at_helper(t);
  }

  void close_leaks() {
    ParitySets parts(tets_.size());
    for (std::uint32_t t = 0; t < tets_.size(); ++t)
      if (leaks(t))
        for (const std::uint32_t n : tets_[t].neighbor)
          if (leaks(n)) parts.join(t, n);
    std::vector<std::uint32_t> leaking;
    std::unordered_map<std::uint32_t, Leak> found;
    double hull = 0;
    Triangle corners;
    for (std::uint32_t t = 0; t < tets_.size(); ++t) {
      if (!tets_[t].alive() || !at_helper(t)) continue;
      if (leaks(t)) leaking.push_back(t);
      for (std::size_t i = 0; i < 4; ++i) {
        if (!corners_of(t, i, corners)) continue;
        const double a = area(corners);
        hull += a;
        if (!leaks(t)) continue;
        Leak& leak = found[parts.find(t).set];
        leak.area += a;
        leak.price += price(corners);
        for (const std::uint32_t v : corners) leak.box.add(samples_.position[v]);
      }
    }
    for (const std::uint32_t t : leaking)
      if (is_mistake(found[parts.find(t).set], hull)) labels_.inside[t] = 0;
  }

  // Doubtful tetrahedra and those around them; never the endless ones.
  void find_region(const Job& job) {
    std::vector<char> marked(tets_.size(), 0);
    Triangle corners;
    for (std::uint32_t t = 0; t < tets_.size(); ++t) {
      if (!tets_[t].alive() || !labels_.inside[t]) continue;
      for (std::size_t i = 0; i < 4; ++i) {
        const std::uint32_t n = tets_[t].neighbor[i];
        if (n == no_index || labels_.inside[n] || !corners_of(t, i, corners)) continue;
        if (openness_.tilt(corners) > doubtful) marked[t] = marked[n] = 1;
      }
    }
    for (const Belief& belief : labels_.beliefs)
      if (labels_.inside[belief.tetrahedron] != belief.inside) marked[belief.tetrahedron] = 1;
    std::vector<char> vertex(samples_.size() + Delaunay::helpers);
    for (int ring = 0; ring < rings; ++ring) {
      job.check();
      std::fill(vertex.begin(), vertex.end(), 0);
      for (std::uint32_t t = 0; t < tets_.size(); ++t)
        if (marked[t])
          for (const std::uint32_t v : tets_[t].v) vertex[v] = v >= Delaunay::helpers;
      for (std::uint32_t t = 0; t < tets_.size(); ++t)
        if (tets_[t].alive())
          for (const std::uint32_t v : tets_[t].v) marked[t] |= vertex[v];
    }
    for (std::uint32_t t = 0; t < tets_.size(); ++t)
      if (marked[t] && tets_[t].alive() && !at_helper(t)) node_[t] = count_++;
  }

  void add_facets(MinCut& cut) const {
    Triangle corners;
    for (std::uint32_t t = 0; t < tets_.size(); ++t) {
      if (node_[t] == no_index) continue;
      for (std::size_t i = 0; i < 4; ++i) {
        const std::uint32_t n = tets_[t].neighbor[i];
        if (n == no_index || (node_[n] != no_index && n < t) || !corners_of(t, i, corners))
          continue;
        const std::int32_t p = whole(price(corners));
        if (node_[n] != no_index)
          cut.add_edge_price(node_[t], node_[n], p);
        else
          cut.add_node_price(node_[t], labels_.inside[n] ? p : 0, labels_.inside[n] ? 0 : p);
      }
    }
  }

  std::span<const Tetrahedron> tets_;
  const MeshSamples& samples_;
  const Openness openness_;
  Labelling& labels_;
  std::vector<std::uint32_t> node_;  // per tetrahedron; none outside of the region
  std::uint32_t count_ = 0;
};

}  // namespace

std::size_t recut_labels(const Delaunay& delaunay, const MeshSamples& samples,
                         const CreaseSides& sides, Labelling& labels, const Job& job) {
  return Recut(delaunay, samples, sides, labels).run(job);
}

}  // namespace spigolo
