// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/flips.cpp
#include "spigolo/mesh/flips.h"

#include <algorithm>

namespace spigolo {
namespace {

const double nearly_plane = std::cos(radians(25));  // between the triangles before the flip
const double least_turn = 1e-9;                     // [rad] over a half turn: lattices have ties
constexpr double sliver_height = 0.02;              // against the length of the border edge
constexpr int most_passes = 20;
constexpr int most_attempts = 3;

class Flipper {
 public:
  Flipper(std::vector<Triangle>& triangles, const std::vector<Vec3>& points,
          std::span<const VertexPair> creases, const std::vector<char>& locked)
      : triangles_(triangles), points_(points), locked_(locked), neighbors_(points.size()) {
    for (const auto& [a, b] : creases) creases_.push_back({std::min(a, b), std::max(a, b)});
    std::sort(creases_.begin(), creases_.end());
  }

  FlipReport run(const Job& job) {
    take_border_slivers();
    const EdgeTable table = find_edges(points_.size(), triangles_);
    twin_ = find_twins(table, triangles_.size());
    for (const MeshEdge& edge : table.edges) {
      neighbors_[edge.low].push_back(edge.high);
      neighbors_[edge.high].push_back(edge.low);
    }
    std::vector<char> active(triangles_.size(), 1);
    for (int pass = 0; pass < most_passes; ++pass) {
      job.check();
      std::size_t flipped = 0;
      std::vector<char> touched(triangles_.size(), 0);
      for (std::uint32_t half = 0; half < twin_.size(); ++half) {
        const std::uint32_t other = twin_[half];
        if (other == no_index || other < half) continue;
        if (!active[half / 3] && !active[other / 3]) continue;
        if (!wants_flip(half, other)) continue;
        flip(half, other);
        touch(half / 3, touched), touch(other / 3, touched);
        ++flipped;
      }
      report_.flipped += flipped;
      active.swap(touched);
      if (flipped == 0) break;
    }
    return report_;
  }

 private:
  std::uint32_t from(std::uint32_t half) const { return triangles_[half / 3][half % 3]; }
  std::uint32_t apex(std::uint32_t half) const { return from(next_half(next_half(half))); }
  Vec3 area_vector(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return cross(points_[b] - points_[a], points_[c] - points_[a]);
  }
  bool is_crease(std::uint32_t a, std::uint32_t b) const {
    return std::binary_search(creases_.begin(), creases_.end(),
                              VertexPair{std::min(a, b), std::max(a, b)});
  }
  void touch(std::uint32_t t, std::vector<char>& touched) const {
    touched[t] = 1;
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h)
      if (twin_[h] != no_index) touched[twin_[h] / 3] = 1;
  }

  // A triangle over a border edge, with its third corner inside and nearly on that edge.
  void take_border_slivers() {
    const EdgeTable table = find_edges(points_.size(), triangles_);
    std::vector<char> at_border(points_.size(), 0), gone(triangles_.size(), 0);
    for (const MeshEdge& edge : table.edges)
      if (edge.count == 1) at_border[edge.low] = at_border[edge.high] = 1;
    for (const MeshEdge& edge : table.edges) {
      if (edge.count != 1 || is_crease(edge.low, edge.high)) continue;
      const std::uint32_t half = table.of(edge)[0];
      const std::uint32_t a = edge.low, b = edge.high, c = apex(half);
      const double length = distance(points_[a], points_[b]);
      if (at_border[c] || norm(area_vector(a, b, c)) > sliver_height * length * length) continue;
      gone[half / 3] = at_border[c] = 1;
    }
    std::size_t n = 0;
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      if (!gone[t]) triangles_[n++] = triangles_[t];
    report_.border_slivers = triangles_.size() - n;
    triangles_.resize(n);
  }

  bool wants_flip(std::uint32_t half, std::uint32_t other) const {
    const std::uint32_t a = from(half), b = from(other), c = apex(half), d = apex(other);
    if (from(next_half(half)) != b || c == d || is_crease(a, b)) return false;
    if (locked_[a] || locked_[b] || locked_[c] || locked_[d]) return false;
    const Vec3 ca = points_[a] - points_[c], cb = points_[b] - points_[c];
    const Vec3 da = points_[a] - points_[d], db = points_[b] - points_[d];
    if (angle_between(ca, cb) + angle_between(da, db) < pi + least_turn) return false;
    const Vec3 n = normalized(area_vector(a, b, c)), m = normalized(area_vector(b, a, d));
    const bool flat = squared_norm(n) > 0 && squared_norm(m) > 0;
    if (flat && dot(n, m) < nearly_plane && !sliver(a, b, c) && !sliver(a, b, d)) return false;
    const Vec3 mean = area_vector(a, b, c) + area_vector(b, a, d);  // by area: slivers say nothing
    if (!(dot(area_vector(c, d, b), mean) > 0) || !(dot(area_vector(d, c, a), mean) > 0))
      return false;
    const auto& near = neighbors_[c];
    return std::find(near.begin(), near.end(), d) == near.end();
  }

  bool sliver(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
    return norm(area_vector(a, b, c)) < sliver_height * squared_distance(points_[a], points_[b]);
  }

  // a b c and b a d become c d b and d c a.
  void flip(std::uint32_t half, std::uint32_t other) {
    const std::uint32_t a = from(half), b = from(other), c = apex(half), d = apex(other);
    const std::uint32_t bc = twin_[next_half(half)], ca = twin_[next_half(next_half(half))];
    const std::uint32_t ad = twin_[next_half(other)], db = twin_[next_half(next_half(other))];
    const std::uint32_t s = half / 3, t = other / 3;
    triangles_[s] = {c, d, b};
    triangles_[t] = {d, c, a};
    link(3 * s, 3 * t);
    link(3 * s + 1, db);
    link(3 * s + 2, bc);
    link(3 * t + 1, ca);
    link(3 * t + 2, ad);
    std::erase(neighbors_[a], b);
    std::erase(neighbors_[b], a);
    neighbors_[c].push_back(d);
    neighbors_[d].push_back(c);
  }
  void link(std::uint32_t half, std::uint32_t other) {
    twin_[half] = other;
    if (other != no_index) twin_[other] = half;
  }

  std::vector<Triangle>& triangles_;
  const std::vector<Vec3>& points_;
  const std::vector<char>& locked_;  // vertices
  std::vector<VertexPair> creases_;
  std::vector<std::uint32_t> twin_;
  std::vector<std::vector<std::uint32_t>> neighbors_;
  FlipReport report_;
};

}  // namespace

FlipReport flip_edges(std::vector<Triangle>& triangles, const std::vector<Vec3>& points,
                      std::span<const VertexPair> creases, const Job& job) {
  const std::vector<Triangle> before = triangles;
  std::vector<char> locked(points.size(), 0);
  for (int attempt = 0;; ++attempt) {
    FlipReport report = Flipper(triangles, points, creases, locked).run(job);
    const auto pairs = find_self_intersections(points, triangles, job);
    report.self_intersections = pairs.size();
    if (pairs.empty() || attempt == most_attempts) return report;
    for (const auto& pair : pairs)
      for (const std::uint32_t t : pair)
        for (const std::uint32_t v : triangles[t]) locked[v] = 1;
    triangles = before;
  }
}

}  // namespace spigolo
