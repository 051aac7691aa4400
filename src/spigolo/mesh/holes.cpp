// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/holes.cpp - loops of border edges closed (G. Barequet, M. Sharir, Filling gaps in
// the boundary of a polyhedron, 1995)
#include <algorithm>

#include "spigolo/mesh/check.h"
#include "spigolo/mesh/trim.h"

namespace spigolo {
namespace {

constexpr double price_of_a_fold = 4;  // times the area of a triangle that folds back

// Least sum of areas over all triangulations of a loop, by dynamic programming.
class Filler {
 public:
  explicit Filler(const std::vector<Vec3>& loop) : n_(loop.size()), p_(loop) {
    for (std::size_t i = 0; i < n_; ++i) normal_ += cross(p_[i], p_[(i + 1) % n_]);
    normal_ = normalized(normal_);
  }

  void run(std::vector<Triangle>& out, const Job& job) {
    std::vector<double> best(n_ * n_, 0);
    std::vector<std::uint32_t> split(n_ * n_, 0);
    for (std::size_t span = 2; span < n_; ++span) {
      job.check();
      for (std::size_t i = 0; i + span < n_; ++i) {
        double& least = best[i * n_ + i + span] = infinity;
        for (std::size_t k = i + 1; k < i + span; ++k) {
          const double price = best[i * n_ + k] + best[k * n_ + i + span] + area(i, k, i + span);
          if (price < least)
            least = price, split[i * n_ + i + span] = static_cast<std::uint32_t>(k);
        }
      }
    }
    std::vector<std::array<std::size_t, 2>> todo{{0, n_ - 1}};
    while (!todo.empty()) {
      const auto [i, j] = todo.back();
      todo.pop_back();
      if (j < i + 2) continue;
      const std::size_t k = split[i * n_ + j];
      out.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(k),
                     static_cast<std::uint32_t>(j)});
      todo.push_back({i, k});
      todo.push_back({k, j});
    }
  }

 private:
  double area(std::size_t i, std::size_t j, std::size_t k) const {
    const Vec3 n = cross(p_[j] - p_[i], p_[k] - p_[i]);
    return norm(n) * (dot(n, normal_) < 0 ? price_of_a_fold : 1);
  }

  std::size_t n_;
  const std::vector<Vec3>& p_;
  Vec3 normal_;
};

}  // namespace

// Border half-edges linked to loops: a hole is on the other side, so it runs against them.
std::vector<BorderLoop> find_border_loops(const std::vector<Triangle>& triangles,
                                          std::size_t vertices) {
  const EdgeTable table = find_edges(vertices, triangles);
  std::vector<std::uint32_t> next(vertices, no_index);
  std::vector<char> twice(vertices, 0);
  for (const MeshEdge& edge : table.edges) {
    if (edge.count != 1) continue;
    const std::uint32_t half = table.of(edge)[0];
    const std::uint32_t from = triangles[half / 3][half % 3],
                        to = triangles[half / 3][(half % 3 + 1) % 3];
    if (next[to] != no_index) twice[to] = 1;
    next[to] = from;
  }
  std::vector<BorderLoop> loops;
  std::vector<char> seen(vertices, 0);
  for (std::uint32_t start = 0; start < vertices; ++start) {
    BorderLoop loop;
    bool clean = true;
    for (std::uint32_t v = start; v != no_index && !seen[v] && next[v] != no_index; v = next[v]) {
      seen[v] = 1;
      clean &= !twice[v];
      loop.push_back(v);
    }
    if (loop.size() >= 3 && clean && next[loop.back()] == loop.front()) loops.push_back(loop);
  }
  return loops;
}

std::vector<Triangle> fill_loop(const std::vector<Vec3>& loop, const Job& job) {
  std::vector<Triangle> triangles;
  if (loop.size() >= 3 && loop.size() <= longest_loop) Filler(loop).run(triangles, job);
  return triangles;
}

// Fillings that run into the mesh or into each other go again.
std::size_t fill_holes(std::vector<Triangle>& triangles, const std::vector<Vec3>& points,
                       double largest, const Job& job) {
  const std::size_t first = triangles.size();
  std::vector<std::size_t> owner;  // per new triangle its hole
  std::size_t filled = 0;
  for (const BorderLoop& loop : find_border_loops(triangles, points.size())) {
    job.check();
    Box box;
    std::vector<Vec3> places;
    for (const std::uint32_t v : loop) box.add(points[v]), places.push_back(points[v]);
    if (norm(box.size()) > largest) continue;
    const std::vector<Triangle> filling = fill_loop(places, job);
    if (filling.empty()) continue;
    for (const auto& [a, b, c] : filling) triangles.push_back({loop[a], loop[b], loop[c]});
    owner.resize(triangles.size() - first, filled++);
  }
  if (filled == 0) return 0;
  std::vector<char> bad(filled, 0);
  for (const auto& pair : find_self_intersections(points, triangles, job))
    for (const std::uint32_t t : pair)
      if (t >= first) bad[owner[t - first]] = 1;
  std::size_t n = first;
  for (std::size_t t = first; t < triangles.size(); ++t)
    if (!bad[owner[t - first]]) triangles[n++] = triangles[t];
  triangles.resize(n);
  return static_cast<std::size_t>(std::count(bad.begin(), bad.end(), 0));
}

}  // namespace spigolo
