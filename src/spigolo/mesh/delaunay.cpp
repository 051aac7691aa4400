// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/delaunay.cpp
#include "spigolo/mesh/delaunay.h"

#include <algorithm>
#include <bit>

#include "spigolo/core/error.h"

namespace spigolo {
namespace {

constexpr std::size_t first_round = 64;  // points of the first round; each next one is 8 times that
constexpr std::size_t steps_between_checks = 4096;

// A number that scatters like a random one but belongs to the vertex.
std::uint64_t scatter(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
  x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
  return x ^ (x >> 31);
}

// Which round inserts a point: the last takes 7 of 8, the one before 7 of 8 of the rest, ...
int round_of(std::uint32_t i, int rounds) {
  const int zeros = std::countr_zero(scatter(i) | (std::uint64_t{1} << 63)) / 3;
  return std::max(0, rounds - 1 - zeros);
}

}  // namespace

Delaunay::Delaunay() {
  const double r = grid_reach;
  points_ = {{r, r, r}, {-r, -r, r}, {-r, r, -r}, {r, -r, -r}};
  if (grid_orient(points_[0], points_[1], points_[2], points_[3]) < 0)
    std::swap(points_[2], points_[3]);
  tets_.push_back({{0, 1, 2, 3}, {no_index, no_index, no_index, no_index}});
  mark_.push_back(0);
  at_.assign(helpers, 0);
  open_.resize(1024);
}

void Delaunay::insert(std::span<const GridPoint> points, std::span<const std::uint32_t> order,
                      const Job& job) {
  for (std::size_t i = points_.size() - helpers; i < points.size(); ++i)
    points_.push_back(points[i]);
  at_.resize(points_.size(), no_index);
  int rounds = 1;
  for (std::size_t n = first_round; n < order.size(); n *= 8) ++rounds;
  std::size_t done = 0;
  for (int round = 0; round < rounds; ++round)
    for (const std::uint32_t i : order) {
      if (round_of(i, rounds) != round) continue;
      insert_one(i + helpers);
      if (++done % steps_between_checks != 0) continue;
      job.check();
      if (job.progress)
        job.progress("tetrahedra", static_cast<double>(done) / static_cast<double>(order.size()));
    }
}

// A point that would make a flat tetrahedron is moved by a grid unit or two.
bool Delaunay::insert_one(std::uint32_t vertex) {
  for (int attempt = 0; attempt < 8; ++attempt) {
    const GridPoint p = points_[vertex];
    const std::uint32_t t = locate(p);
    if (t == no_index) return false;
    for (const std::uint32_t v : tets_[t].v)
      if (points_[v] == p) return false;
    find_cavity(t, p);
    if (star_shaped(p)) {
      fill_cavity(vertex);
      return true;
    }
    const std::uint64_t bits = scatter(vertex + (static_cast<std::uint64_t>(attempt) << 32));
    points_[vertex] += {static_cast<double>(bits % 5) - 2, static_cast<double>(bits / 5 % 5) - 2,
                        static_cast<double>(bits / 25 % 5) - 2};
  }
  return false;
}

// Walks towards p; in a Delaunay triangulation that ends.
std::uint32_t Delaunay::locate(const GridPoint& p) const {
  std::uint32_t t = last_, from = no_index;
  while (t != no_index) {
    const Tetrahedron& tet = tets_[t];
    std::size_t out = 4;
    for (std::size_t i = 0; i < 4 && out == 4; ++i) {
      if (tet.neighbor[i] == from && from != no_index) continue;
      const auto& f = facet_corners[i];
      if (grid_orient(p, points_[tet.v[f[0]]], points_[tet.v[f[1]]], points_[tet.v[f[2]]]) < 0)
        out = i;
    }
    if (out == 4) return t;
    from = t;
    t = tet.neighbor[out];
  }
  return no_index;
}

bool Delaunay::in_conflict(std::uint32_t t, const GridPoint& p) const {
  const auto& v = tets_[t].v;
  return grid_in_sphere(points_[v[0]], points_[v[1]], points_[v[2]], points_[v[3]], p) > 0;
}

void Delaunay::find_cavity(std::uint32_t first, const GridPoint& p) {
  ++stamp_;
  cavity_.assign(1, first);
  rim_.clear();
  mark_[first] = 2 * stamp_;
  for (std::size_t next = 0; next < cavity_.size(); ++next) {
    const std::uint32_t t = cavity_[next];
    for (std::uint8_t i = 0; i < 4; ++i) {
      const std::uint32_t n = tets_[t].neighbor[i];
      if (n != no_index && mark_[n] == 2 * stamp_) continue;
      if (n != no_index && mark_[n] != 2 * stamp_ + 1) {
        if (in_conflict(n, p)) {
          mark_[n] = 2 * stamp_;
          cavity_.push_back(n);
          continue;
        }
        mark_[n] = 2 * stamp_ + 1;
      }
      rim_.push_back({t, i});
    }
  }
}

bool Delaunay::star_shaped(const GridPoint& p) const {
  return std::all_of(rim_.begin(), rim_.end(), [&](const Facet& facet) {
    const auto& v = tets_[facet.tet].v;
    const auto& f = facet_corners[facet.corner];
    return grid_orient(p, points_[v[f[0]]], points_[v[f[1]]], points_[v[f[2]]]) > 0;
  });
}

std::uint32_t Delaunay::new_slot(std::size_t& reused) {
  if (reused < cavity_.size()) return cavity_[reused++];
  if (!free_.empty()) {
    const std::uint32_t t = free_.back();
    free_.pop_back();
    return t;
  }
  tets_.emplace_back();
  mark_.push_back(0);
  return static_cast<std::uint32_t>(tets_.size() - 1);
}

// Each facet of the rim becomes a tetrahedron with the new vertex. All old ones are read before
// their slots are written again.
void Delaunay::fill_cavity(std::uint32_t vertex) {
  made_.clear();
  for (const Facet& facet : rim_) {
    const std::uint32_t outside = tets_[facet.tet].neighbor[facet.corner];
    std::uint8_t back = 0;
    if (outside != no_index)
      while (tets_[outside].neighbor[back] != facet.tet) ++back;
    made_.push_back({tets_[facet.tet].v, outside, facet.corner, back});
  }
  if (open_.size() < 8 * rim_.size()) open_.assign(std::bit_ceil(8 * rim_.size()), {});
  ++open_stamp_;
  std::size_t reused = 0;
  for (Made& made : made_) {
    const std::uint32_t slot = new_slot(reused);
    made.v[made.corner] = vertex;
    tets_[slot].v = made.v;
    tets_[slot].neighbor[made.corner] = made.outside;
    if (made.outside != no_index) tets_[made.outside].neighbor[made.back] = slot;
    for (const std::uint32_t v : made.v) at_[v] = slot;
    for (std::uint8_t i = 0; i < 4; ++i)
      if (i != made.corner) link({slot, i}, made.corner);
    mark_[slot] = 0;
    last_ = slot;
  }
  for (; reused < cavity_.size(); ++reused) {
    tets_[cavity_[reused]].v[0] = no_index;
    free_.push_back(cavity_[reused]);
  }
}

// Two new tetrahedra share each facet at the new vertex: whoever comes second finds the first by
// the edge they share on the rim.
void Delaunay::link(Facet facet, std::size_t apex) {
  std::array<std::uint32_t, 2> edge{};
  std::size_t n = 0;
  for (std::size_t i = 0; i < 4; ++i)
    if (i != facet.corner && i != apex) edge[n++] = tets_[facet.tet].v[i];
  const auto [low, high] = std::minmax(edge[0], edge[1]);
  const std::uint64_t key = std::uint64_t{high} << 32 | low;
  std::size_t at = scatter(key) & (open_.size() - 1);
  while (open_[at].stamp == open_stamp_ && open_[at].key != key) at = (at + 1) & (open_.size() - 1);
  if (open_[at].stamp != open_stamp_) {
    open_[at] = {key, open_stamp_, facet};
    return;
  }
  const Facet first = open_[at].facet;
  tets_[facet.tet].neighbor[facet.corner] = first.tet;
  tets_[first.tet].neighbor[first.corner] = facet.tet;
}

void Delaunay::star(std::uint32_t vertex, std::vector<std::uint32_t>& tets) const {
  tets.assign(1, at_[vertex]);
  // Most neighbors are new or were seen a moment ago: a set of 64 bits spares most searches.
  const auto bit = [](std::uint32_t t) { return std::uint64_t{1} << (t * 0x9e3779b1u >> 26); };
  std::uint64_t seen = bit(tets[0]);
  for (std::size_t next = 0; next < tets.size(); ++next) {
    const Tetrahedron& t = tets_[tets[next]];
    for (std::size_t i = 0; i < 4; ++i) {
      const std::uint32_t n = t.neighbor[i];
      if (t.v[i] == vertex || n == no_index) continue;
      if ((seen & bit(n)) != 0 && std::find(tets.begin(), tets.end(), n) != tets.end()) continue;
      seen |= bit(n);
      tets.push_back(n);
    }
  }
}

void Delaunay::around(std::uint32_t a, std::uint32_t b, std::vector<std::uint32_t>& tets) const {
  star(a, tets);
  std::erase_if(tets, [&](std::uint32_t t) {
    return std::find(tets_[t].v.begin(), tets_[t].v.end(), b) == tets_[t].v.end();
  });
}

// The ray leaves the vertex between the three edges of the right one.
std::uint32_t Delaunay::towards(std::uint32_t vertex, const Vec3& direction,
                                std::span<const std::uint32_t> star) const {
  const Vec3& p = points_[vertex];
  std::uint32_t best = no_index;
  double best_margin = -infinity;
  for (const std::uint32_t t : star) {
    const auto& v = tets_[t].v;
    const auto at = static_cast<std::size_t>(std::find(v.begin(), v.end(), vertex) - v.begin());
    const auto& f = facet_corners[at];
    const Vec3 a = normalized(points_[v[f[0]]] - p), b = normalized(points_[v[f[1]]] - p),
               c = normalized(points_[v[f[2]]] - p);
    // barycentric coordinates of the direction among the three edges; positive orientation
    const double det = dot(a, cross(b, c));
    const double ua = dot(direction, cross(b, c)), ub = dot(direction, cross(c, a)),
                 uc = dot(direction, cross(a, b));
    const double margin = std::min({ua, ub, uc}) / std::max(std::abs(det), 1e-12);
    const double signed_margin = det > 0 ? margin : -std::max({ua, ub, uc}) / std::max(-det, 1e-12);
    if (signed_margin > best_margin) best_margin = signed_margin, best = t;
  }
  return best;
}

}  // namespace spigolo
