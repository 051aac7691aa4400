// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/separate.cpp
#include "spigolo/mesh/separate.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "spigolo/core/parity_sets.h"

namespace spigolo {
namespace {

constexpr int most_rounds = 8;  // a triangle is cut at one edge a round

class Separator {
 public:
  Separator(TriangleMesh& mesh, std::vector<VertexPair>& creases)
      : triangles_(mesh.triangles), points_(mesh.vertices.points), creases_(creases) {}

  std::size_t run() {
    const std::size_t before = points_.size();
    for (int round = 0; round < most_rounds; ++round) {
      table_ = find_edges(points_.size(), triangles_);
      pair_halves();
      split_vertices();
      table_ = find_edges(points_.size(), triangles_);
      if (!cut_edges()) break;
    }
    return points_.size() - before;
  }

 private:
  std::uint32_t from(std::uint32_t half) const { return triangles_[half / 3][half % 3]; }
  std::uint32_t to(std::uint32_t half) const { return from(next_half(half)); }
  std::uint32_t apex(std::uint32_t half) const { return from(next_half(next_half(half))); }

  void pair(std::uint32_t a, std::uint32_t b) { twin_[a] = b, twin_[b] = a; }

  void pair_halves() {
    twin_.assign(3 * triangles_.size(), no_index);
    for (const MeshEdge& edge : table_.edges) {
      const auto halves = table_.of(edge);
      if (edge.count == 2) pair(halves[0], halves[1]);
      if (edge.count > 2) pair_around(edge);
    }
  }

  // Of a triangle that runs low to high, the outside is where a turn about the edge leads, so its
  // partner is the one before it.
  void pair_around(const MeshEdge& edge) {
    const Vec3 axis = normalized(points_[edge.high] - points_[edge.low]);
    const Vec3 x = any_perpendicular(axis), y = cross(axis, x);
    std::vector<std::pair<double, std::uint32_t>> around;
    for (const std::uint32_t half : table_.of(edge)) {
      const Vec3 d = points_[apex(half)] - points_[edge.low];
      around.push_back({std::atan2(dot(d, y), dot(d, x)), half});
    }
    std::sort(around.begin(), around.end());
    for (std::size_t i = 0; i < around.size(); ++i) {
      const std::uint32_t before = around[(i + around.size() - 1) % around.size()].second;
      if (from(around[i].second) == edge.low && from(before) == edge.high)
        pair(around[i].second, before);
    }
  }

  // The first fan at a vertex keeps it.
  void split_vertices() {
    ParitySets fans(3 * triangles_.size());
    for (std::uint32_t half = 0; half < twin_.size(); ++half) {
      const std::uint32_t other = twin_[half];
      if (other == no_index || other < half) continue;
      const bool opposite = from(half) == to(other);
      fans.join(half, opposite ? next_half(other) : other);
      fans.join(next_half(half), opposite ? other : next_half(other));
    }
    const std::vector<Triangle> before = triangles_;
    std::vector<std::uint32_t> owner(points_.size(), no_index), made(twin_.size(), no_index);
    for (std::uint32_t corner = 0; corner < made.size(); ++corner) {
      const std::uint32_t fan = fans.find(corner).set, v = before[corner / 3][corner % 3];
      if (owner[v] == no_index) owner[v] = fan;
      if (owner[v] == fan) continue;
      if (made[fan] == no_index) made[fan] = add(points_[v]);
      triangles_[corner / 3][corner % 3] = made[fan];
    }
    for (auto& [a, b] : creases_)
      if (const MeshEdge* edge = table_.find(a, b)) {
        const std::uint32_t half = table_.of(*edge)[0];
        a = from(half), b = to(half);
      }
  }

  std::uint32_t add(Vec3 p) {  // by value: p may live in points_
    points_.push_back(p);
    return static_cast<std::uint32_t>(points_.size() - 1);
  }

  // Pairs that are joined at both ends of an edge are cut in its middle. False if there are none.
  bool cut_edges() {
    bool any = false;
    std::vector<char> touched(triangles_.size(), 0);
    for (const MeshEdge& edge : table_.edges) {
      if (edge.count <= 2) continue;
      any = true;
      const auto halves = table_.of(edge);
      if (std::any_of(halves.begin(), halves.end(), [&](auto h) { return touched[h / 3]; }))
        continue;
      cut(edge);
      for (const std::uint32_t half : halves) touched[half / 3] = 1;
    }
    return any;
  }

  void cut(const MeshEdge& edge) {
    const Vec3 middle = (points_[edge.low] + points_[edge.high]) * 0.5;
    std::uint32_t first = no_index;
    for (const std::uint32_t half : table_.of(edge)) {
      const std::uint32_t other = twin_[half];
      if (other != no_index && other < half) continue;
      const std::uint32_t m = add(middle);
      if (first == no_index) first = m;
      for (const std::uint32_t h : {half, other}) {
        if (h == no_index) continue;
        const std::uint32_t b = to(h), c = apex(h);
        triangles_[h / 3][(h % 3 + 1) % 3] = m;
        triangles_.push_back({m, b, c});
      }
    }
    for (std::size_t s = 0, n = creases_.size(); s < n; ++s) {
      const auto [a, b] = creases_[s];
      if (std::min(a, b) != edge.low || std::max(a, b) != edge.high) continue;
      creases_[s] = {a, first};
      creases_.push_back({first, b});
    }
  }

  std::vector<Triangle>& triangles_;
  std::vector<Vec3>& points_;
  std::vector<VertexPair>& creases_;
  EdgeTable table_;
  std::vector<std::uint32_t> twin_;  // per half-edge
};

}  // namespace

std::size_t separate(TriangleMesh& mesh, std::vector<VertexPair>& creases) {
  return Separator(mesh, creases).run();
}

}  // namespace spigolo
