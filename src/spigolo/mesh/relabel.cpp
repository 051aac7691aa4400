// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/relabel.cpp
#include "spigolo/mesh/relabel.h"

#include <algorithm>

#include "spigolo/core/parity_sets.h"
#include "spigolo/mesh/openness.h"

namespace spigolo {
namespace {

constexpr double flat_enough = radians(20);    // facets tilted less against the sheets cost no more
constexpr double too_steep = radians(50);      // facets tilted more cost the most
constexpr double price_of_area = 0.1;          // against 1 for a facet that is too steep
constexpr double bubble_price = 0.3;           // a part with a dearer surface is no part
constexpr std::uint32_t largest_bubble = 200;  // facets; a larger part is one, whatever it costs
constexpr double least_gain = 1e-4;
constexpr double gain_of_a_vertex = 0.2;  // what leaving a vertex out must bring
constexpr int most_sweeps = 12;
constexpr int most_rounds = 12;

using Tets = std::vector<std::uint32_t>;

class Relabeller {
 public:
  Relabeller(const Delaunay& delaunay, const MeshSamples& samples, const CreaseSides& sides,
             Labelling& labels)
      : delaunay_(delaunay),
        tets_(delaunay.tetrahedra()),
        samples_(samples),
        openness_(delaunay, samples, sides),
        inside_(labels.inside),
        marked_(tets_.size(), 0) {
    for (const auto& [a, b] : samples.creases) {
      crease_neighbors_.push_back({a, b});
      crease_neighbors_.push_back({b, a});
    }
    std::sort(crease_neighbors_.begin(), crease_neighbors_.end());
  }

  RelabelReport run(const Job& job) {
    drop_bubbles();
    job.check();
    descend();
    for (int round = 0; round < most_rounds && untangle(); ++round) {
      job.check();
      descend();
    }
    return report_;
  }

 private:
  // In squared edge lengths; facets at the helpers are free.
  double cost(std::uint32_t t, std::size_t i) const {
    Triangle corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = tets_[t].v[facet_corners[i][k]];
      if (v < Delaunay::helpers) return 0;
      corners[k] = v - Delaunay::helpers;
    }
    const Vec3 &a = samples_.position[corners[0]], &b = samples_.position[corners[1]],
               &c = samples_.position[corners[2]];
    const double length = samples_.length[corners[0]];
    const double area = norm(cross(b - a, c - a)) / (2 * length * length);
    const double steep = (openness_.tilt(corners) - flat_enough) / (too_steep - flat_enough);
    return area * (price_of_area + std::clamp(steep, 0.0, 1.0));
  }

  bool is_boundary(std::uint32_t t, std::size_t i) const {
    const std::uint32_t n = tets_[t].neighbor[i];
    return n != no_index && inside_[n] != inside_[t];
  }

  // What the surface costs more after the tetrahedra of a set, all of one label, change sides.
  double price_of_turning(const Tets& set) {
    for (const std::uint32_t t : set) marked_[t] = 1;
    double price = 0;
    for (const std::uint32_t t : set)
      for (std::size_t i = 0; i < 4; ++i) {
        const std::uint32_t n = tets_[t].neighbor[i];
        if (n == no_index) price = infinity;
        if (n == no_index || marked_[n]) continue;
        price += inside_[n] != inside_[t] ? -cost(t, i) : cost(t, i);
      }
    for (const std::uint32_t t : set) marked_[t] = 0;
    return price;
  }

  void turn(const Tets& set) {
    for (const std::uint32_t t : set) inside_[t] ^= 1;
  }

  // Parts of one label that hang together; those with a bad surface join what is around them.
  void drop_bubbles() {
    ParitySets parts(tets_.size());
    for (std::uint32_t t = 0; t < tets_.size(); ++t)
      for (std::size_t i = 0; i < 4 && tets_[t].alive(); ++i)
        if (tets_[t].neighbor[i] < t && !is_boundary(t, i)) parts.join(t, tets_[t].neighbor[i]);
    std::vector<double> price(tets_.size(), 0);
    std::vector<std::uint32_t> facets(tets_.size(), 0);
    std::vector<char> endless(tets_.size(), 0);
    for (std::uint32_t t = 0; t < tets_.size(); ++t) {
      if (!tets_[t].alive()) continue;
      const std::uint32_t part = parts.find(t).set;
      for (std::size_t i = 0; i < 4; ++i) {
        if (tets_[t].v[i] < Delaunay::helpers) endless[part] = 1;
        if (!is_boundary(t, i)) continue;
        price[part] += cost(t, i);
        ++facets[part];
      }
    }
    for (std::uint32_t t = 0; t < tets_.size(); ++t) {
      if (!tets_[t].alive()) continue;
      const std::uint32_t part = parts.find(t).set;
      if (endless[part] && inside_[t] == 0) continue;
      if (facets[part] > largest_bubble || price[part] <= bubble_price * facets[part]) continue;
      inside_[t] ^= 1;
      if (part == t) ++report_.bubbles;
    }
  }

  // Sweeps over the tetrahedra at the surface until none gains.
  void descend() {
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
      std::size_t turned = 0;
      for (std::uint32_t t = 0; t < tets_.size(); ++t)
        if (tets_[t].alive() && gains(t)) {
          inside_[t] ^= 1;
          ++turned;
        }
      report_.turned += turned;
      if (turned == 0) break;
    }
  }

  bool gains(std::uint32_t t) {
    std::array<std::size_t, 4> side{};  // facets at the surface first
    std::size_t n = 0, rest = 4;
    for (std::size_t i = 0; i < 4; ++i) is_boundary(t, i) ? side[n++] = i : side[--rest] = i;
    if (n == 0) return false;
    if (n == 4) return true;
    double gain = 0;
    for (std::size_t k = 0; k < 4; ++k) gain += (k < n ? 1 : -1) * cost(t, side[k]);
    if (n == 3) {  // the corner opposite to the one facet inside goes
      const std::uint32_t v = tets_[t].v[side[3]];
      return gain > gain_of_a_vertex && !helper(v) && !samples_.on_crease(v - Delaunay::helpers);
    }
    if (gain < least_gain) return false;
    const auto& v = tets_[t].v;
    if (n == 1) return !at_surface(v[side[0]]);  // the corner opposite to the one facet comes in
    // the edge both facets share goes, the opposite one comes
    return !is_crease(v[side[2]], v[side[3]]) && !at_surface(v[side[0]], v[side[1]]);
  }

  static bool helper(std::uint32_t v) { return v < Delaunay::helpers; }

  bool is_crease(std::uint32_t a, std::uint32_t b) const {
    if (helper(a) || helper(b)) return true;
    return std::binary_search(crease_neighbors_.begin(), crease_neighbors_.end(),
                              VertexPair{a - Delaunay::helpers, b - Delaunay::helpers});
  }

  bool mixed(const Tets& tets) const {
    return std::any_of(tets.begin(), tets.end(),
                       [&](std::uint32_t t) { return inside_[t] != inside_[tets[0]]; });
  }
  // Helpers belong to the outside, and their stars are large.
  bool at_surface(std::uint32_t v) {
    if (helper(v)) return true;
    delaunay_.star(v, star_);
    return mixed(star_);
  }
  bool at_surface(std::uint32_t a, std::uint32_t b) {
    if (helper(a) || helper(b)) return true;
    delaunay_.around(a, b, star_);
    return mixed(star_);
  }

  // The tetrahedra of a ball around an edge or a vertex fall into parts of one label that touch in
  // facets. A surface passes through once if there is one part inside and one outside.
  std::vector<Tets> parts_of(const Tets& ball) {
    std::vector<Tets> parts;
    for (const std::uint32_t t : ball) marked_[t] = 1;
    for (const std::uint32_t seed : ball) {
      if (marked_[seed] != 1) continue;
      Tets part{seed};
      marked_[seed] = 2;
      for (std::size_t next = 0; next < part.size(); ++next)
        for (const std::uint32_t n : tets_[part[next]].neighbor)
          if (n != no_index && marked_[n] == 1 && inside_[n] == inside_[seed]) {
            marked_[n] = 2;
            part.push_back(n);
          }
      parts.push_back(std::move(part));
    }
    for (const std::uint32_t t : ball) marked_[t] = 0;
    return parts;
  }

  // Turns the cheapest part that is one of several of its label.
  bool untangle(const Tets& ball) {
    std::vector<Tets> parts = parts_of(ball);
    if (parts.size() <= 2) return false;
    const auto inner = std::count_if(parts.begin(), parts.end(),
                                     [&](const Tets& p) { return inside_[p[0]] == 1; });
    const auto outer = static_cast<std::ptrdiff_t>(parts.size()) - inner;
    const Tets* best = nullptr;
    double least = infinity;
    for (const Tets& part : parts) {
      if ((inside_[part[0]] ? inner : outer) < 2) continue;
      const double price = price_of_turning(part);
      if (price < least) least = price, best = &part;
    }
    if (best == nullptr) return false;
    turn(*best);
    ++report_.untangled;
    return true;
  }

  bool untangle() {
    Labelling now;
    now.inside = inside_;
    const std::vector<Triangle> triangles = boundary(delaunay_, now);
    const EdgeTable table = find_edges(samples_.size(), triangles);
    bool changed = false;
    report_.tangled = 0;
    Tets ball;
    for (const MeshEdge& edge : table.edges) {
      if (edge.count <= 2) continue;
      ++report_.tangled;
      delaunay_.around(edge.low + Delaunay::helpers, edge.high + Delaunay::helpers, ball);
      changed |= untangle(ball);
    }
    for (const std::uint32_t v : find_fan_vertices(samples_.size(), triangles, table)) {
      ++report_.tangled;
      delaunay_.star(v + Delaunay::helpers, ball);
      changed |= untangle(ball);
    }
    return changed;
  }

  const Delaunay& delaunay_;
  std::span<const Tetrahedron> tets_;
  const MeshSamples& samples_;
  const Openness openness_;
  std::vector<std::uint8_t>& inside_;
  std::vector<std::uint8_t> marked_;  // scratch, all 0 between calls
  std::vector<VertexPair> crease_neighbors_;
  Tets star_;
  RelabelReport report_;
};

}  // namespace

RelabelReport refine_labels(const Delaunay& delaunay, const MeshSamples& samples,
                            const CreaseSides& sides, Labelling& labels, const Job& job) {
  return Relabeller(delaunay, samples, sides, labels).run(job);
}

std::vector<Triangle> boundary(const Delaunay& delaunay, const Labelling& labels) {
  std::vector<Triangle> triangles;
  const auto tets = delaunay.tetrahedra();
  for (std::size_t t = 0; t < tets.size(); ++t) {
    if (!tets[t].alive() || !labels.inside[t]) continue;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::uint32_t n = tets[t].neighbor[i];
      if (n == no_index || labels.inside[n]) continue;
      Triangle corners;
      for (std::size_t k = 0; k < 3; ++k) corners[k] = tets[t].v[facet_corners[i][k]];
      if (*std::min_element(corners.begin(), corners.end()) < Delaunay::helpers) continue;
      for (std::uint32_t& v : corners) v -= Delaunay::helpers;
      triangles.push_back(corners);
    }
  }
  return triangles;
}

}  // namespace spigolo
