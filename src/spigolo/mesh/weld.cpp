// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/weld.cpp
#include "spigolo/mesh/weld.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include "spigolo/mesh/point_cells.h"

namespace spigolo {
namespace {

constexpr double same_vertex = 0.3;   // [steps] samples of one curve are .67 apart and more
constexpr double same_corner = 0.05;  // [steps] corners and ends may be close, not on each other
constexpr double on_segment = 0.1;    // [steps]

class Welder {
 public:
  explicit Welder(MeshSamples& samples)
      : samples_(samples), at_(samples.size(), 0), goal_(samples.size()) {
    for (const VertexPair& segment : samples.creases)
      for (const std::uint32_t v : segment) ++at_[v];
    std::iota(goal_.begin(), goal_.end(), 0U);
  }

  void run() {
    join_vertices();
    cut_segments();
    keep_one_of_each();
    drop_unused();
  }

 private:
  bool inner(std::uint32_t v) const { return at_[v] == 2; }

  // Corners and ends first: they stay where they are.
  void join_vertices() {
    std::vector<std::uint32_t> order(samples_.size()), kept;
    std::iota(order.begin(), order.end(), 0U);
    std::stable_partition(order.begin(), order.end(), [&](std::uint32_t v) { return !inner(v); });
    PointCells cells(samples_.step, samples_.size());
    for (const std::uint32_t v : order) {
      const Vec3& p = samples_.position[v];
      double nearest = infinity;
      cells.any_within(p, same_vertex * samples_.step, [&](std::uint32_t i, double squared) {
        const bool close = inner(v) || inner(kept[i]) || squared <= squared_same_corner();
        if (close && squared < nearest) nearest = squared, goal_[v] = kept[i];
        return false;
      });
      if (goal_[v] != v) continue;
      cells.insert(p);
      kept.push_back(v);
    }
    for (VertexPair& segment : samples_.creases)
      for (std::uint32_t& v : segment) v = goal_[v];
  }

  double squared_same_corner() const {
    return same_corner * same_corner * samples_.step * samples_.step;
  }

  // Every segment at the vertices that lie on it.
  void cut_segments() {
    PointCells cells(samples_.step, samples_.size());
    for (const Vec3& p : samples_.position) cells.insert(p);
    std::vector<VertexPair> creases;
    std::vector<std::int32_t> curve;
    for (std::size_t s = 0; s < samples_.creases.size(); ++s) {
      const auto [first, last] = samples_.creases[s];
      std::uint32_t before = first;
      for (const std::uint32_t v : between(cells, first, last)) {
        creases.push_back({std::exchange(before, v), v});
        curve.push_back(samples_.curve[s]);
      }
      creases.push_back({before, last});
      curve.push_back(samples_.curve[s]);
    }
    samples_.creases = std::move(creases);
    samples_.curve = std::move(curve);
  }

  std::vector<std::uint32_t> between(const PointCells& cells, std::uint32_t first,
                                     std::uint32_t last) const {
    const Vec3 &a = samples_.position[first], d = samples_.position[last] - a;
    const double length = norm(d), near = on_segment * samples_.step;
    std::vector<std::pair<double, std::uint32_t>> found;
    cells.any_within(a + d * 0.5, length / 2, [&](std::uint32_t v, double) {
      if (v == first || v == last || goal_[v] != v) return false;
      const Vec3 to = samples_.position[v] - a;
      const double along = dot(to, d) / length;
      if (along > near && along < length - near && norm(to - d * (along / length)) < near)
        found.push_back({along, v});
      return false;
    });
    std::sort(found.begin(), found.end());
    std::vector<std::uint32_t> which;
    for (const auto& [along, v] : found) which.push_back(v);
    return which;
  }

  void keep_one_of_each() {
    std::set<VertexPair> seen;
    std::size_t n = 0;
    for (std::size_t s = 0; s < samples_.creases.size(); ++s) {
      const VertexPair segment = samples_.creases[s];
      const auto [low, high] = std::minmax(segment[0], segment[1]);
      if (low == high || !seen.insert({low, high}).second) continue;
      samples_.creases[n] = segment;
      samples_.curve[n++] = samples_.curve[s];
    }
    samples_.creases.resize(n);
    samples_.curve.resize(n);
  }

  void drop_unused() {
    std::vector<std::uint32_t> number(samples_.size(), no_index);
    std::uint32_t n = 0;
    for (std::uint32_t v = 0; v < number.size(); ++v) {
      if (goal_[v] != v) continue;
      samples_.position[n] = samples_.position[v];
      samples_.normal[n] = samples_.normal[v];
      samples_.length[n] = samples_.length[v];
      number[v] = n++;
    }
    samples_.position.resize(n);
    samples_.normal.resize(n);
    samples_.length.resize(n);
    for (VertexPair& segment : samples_.creases)
      for (std::uint32_t& v : segment) v = number[v];
  }

  MeshSamples& samples_;
  std::vector<int> at_;              // per vertex, segments that end there
  std::vector<std::uint32_t> goal_;  // per vertex the one it becomes
};

}  // namespace

void weld_creases(MeshSamples& samples) { Welder(samples).run(); }

}  // namespace spigolo
