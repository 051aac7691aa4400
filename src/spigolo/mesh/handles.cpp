// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/handles.cpp
#include "spigolo/mesh/handles.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <unordered_map>

namespace spigolo {
namespace {

class Handles {
 public:
  Handles(const std::vector<Triangle>& triangles, std::size_t vertices)
      : triangles_(triangles), table_(find_edges(vertices, triangles)), neighbors_(vertices) {
    twin_ = find_twins(table_, triangles.size());
    for (const MeshEdge& edge : table_.edges) {
      neighbors_[edge.low].push_back(edge.high);
      neighbors_[edge.high].push_back(edge.low);
    }
    for (auto& list : neighbors_) std::sort(list.begin(), list.end());
  }

  std::vector<Triangle> find(const Job& job) const {
    std::vector<Triangle> found;
    std::vector<std::uint32_t> common;
    for (const MeshEdge& edge : table_.edges) {
      if (edge.count != 2) continue;
      const auto &a = neighbors_[edge.low], &b = neighbors_[edge.high];
      common.clear();
      std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
      if (common.size() <= 2) continue;  // the corners opposite to the edge
      job.check();
      for (const std::uint32_t v : common)
        if (v > edge.high && around({edge.low, edge.high, v}))
          found.push_back({edge.low, edge.high, v});
    }
    return found;
  }

 private:
  // The half-edge from a to b; none at a border or where the edge is not manifold.
  std::uint32_t half(std::uint32_t a, std::uint32_t b) const {
    const MeshEdge* edge = table_.find(a, b);
    if (edge == nullptr || edge->count != 2) return no_index;
    for (const std::uint32_t h : table_.of(*edge))
      if (triangles_[h / 3][h % 3] == a) return h;
    return no_index;
  }

  // No triangle, and both of its sides are one.
  bool around(const Triangle& loop) const {
    std::array<std::uint32_t, 6> walls{};
    for (std::size_t i = 0; i < 3; ++i) {
      walls[2 * i] = half(loop[i], loop[(i + 1) % 3]);
      walls[2 * i + 1] = half(loop[(i + 1) % 3], loop[i]);
    }
    if (std::find(walls.begin(), walls.end(), no_index) != walls.end()) return false;
    if (walls[0] / 3 == walls[2] / 3 || walls[1] / 3 == walls[3] / 3) return false;
    return meet(walls);
  }

  // Grows from both sides of a loop by turns until they meet or one has nowhere to go.
  bool meet(const std::array<std::uint32_t, 6>& walls) const {
    std::unordered_map<std::uint32_t, std::size_t> side;
    std::array<std::vector<std::uint32_t>, 2> reached;
    std::array<std::size_t, 2> next{};
    for (const std::size_t s : {0u, 1u}) {
      reached[s].push_back(walls[s] / 3);
      side[walls[s] / 3] = s;
    }
    for (std::size_t s = 0; next[s] < reached[s].size(); s = 1 - s) {
      const std::uint32_t t = reached[s][next[s]++];
      for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
        if (twin_[h] == no_index || std::find(walls.begin(), walls.end(), h) != walls.end())
          continue;
        const auto [it, fresh] = side.emplace(twin_[h] / 3, s);
        if (!fresh && it->second != s) return true;
        if (fresh) reached[s].push_back(twin_[h] / 3);
      }
    }
    return false;
  }

  const std::vector<Triangle>& triangles_;
  EdgeTable table_;
  std::vector<std::uint32_t> twin_;
  std::vector<std::vector<std::uint32_t>> neighbors_;
};

}  // namespace

std::size_t cut_handles(std::vector<Triangle>& triangles, std::size_t vertices, const Job& job) {
  const std::vector<Triangle> found = Handles(triangles, vertices).find(job);
  if (found.empty()) return 0;
  std::vector<char> taken(vertices, 0);
  std::size_t cut = 0;
  for (const Triangle& loop : found) {  // those that share a corner are one tunnel
    const bool known =
        std::any_of(loop.begin(), loop.end(), [&](std::uint32_t v) { return taken[v] != 0; });
    if (known) continue;
    for (const std::uint32_t v : loop) taken[v] = 1;
    ++cut;
  }
  std::erase_if(triangles, [&](const Triangle& t) {
    return std::any_of(t.begin(), t.end(), [&](std::uint32_t v) { return taken[v] != 0; });
  });
  return cut;
}

}  // namespace spigolo
