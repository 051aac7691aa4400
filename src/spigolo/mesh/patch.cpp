// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/patch.cpp - refinement after P. Liepa, Filling holes in meshes (2003); the shape
// from the graph Laplacian, once (tension) or squared (bending)
#include "spigolo/mesh/patch.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <utility>

namespace spigolo {
namespace {

constexpr int most_passes = 30;  // each cuts the longest edges by about a third
constexpr double longest_edge =
    1.3;                         // [steps] offsets are for edges up to that long: they stay bounded
constexpr int rounds = 8;        // in which the shape of a plate settles
constexpr int most_turns = 10;   // sweeps of edge turning a pass
const double least_turn = 1e-9;  // [rad] over a half turn

using Matrix = Eigen::SparseMatrix<double>;
using Entries = std::vector<Eigen::Triplet<double>>;

double opposite_angle(const std::vector<Vec3>& p, std::uint32_t apex, std::uint32_t a,
                      std::uint32_t b) {
  return angle_between(p[a] - p[apex], p[b] - p[apex]);
}

// Delaunay as far as that goes in space: the diagonal with the smaller angles opposite.
bool turn_edges(HolePatch& patch) {
  auto& triangles = patch.triangles;
  const EdgeTable table = find_edges(patch.points.size(), triangles);
  std::vector<char> touched(triangles.size(), 0);
  bool any = false;
  for (const MeshEdge& edge : table.edges) {
    if (edge.count != 2) continue;
    const auto halves = table.of(edge);
    const std::uint32_t s = halves[0] / 3, t = halves[1] / 3;
    if (touched[s] || touched[t]) continue;
    const auto corner = [&](std::uint32_t half) { return triangles[half / 3][half % 3]; };
    const std::uint32_t a = corner(halves[0]), b = corner(next_half(halves[0]));
    const std::uint32_t c = corner(next_half(next_half(halves[0]))),
                        d = corner(next_half(next_half(halves[1])));
    if (c == d || table.find(c, d) != nullptr) continue;
    if (opposite_angle(patch.points, c, a, b) + opposite_angle(patch.points, d, a, b) <
        pi + least_turn)
      continue;
    triangles[s] = {c, d, b};
    triangles[t] = {d, c, a};
    touched[s] = touched[t] = 1;
    any = true;
  }
  return any;
}

bool insert_middles(HolePatch& patch, double step) {
  bool any = false;
  for (std::size_t t = 0, n = patch.triangles.size(); t < n; ++t) {
    const auto [a, b, c] = patch.triangles[t];
    const Vec3 middle = (patch.points[a] + patch.points[b] + patch.points[c]) / 3;
    double nearest = infinity;
    for (const std::uint32_t v : {a, b, c})
      nearest = std::min(nearest, distance(middle, patch.points[v]));
    if (nearest * std::sqrt(2.0) < step) continue;
    const auto m = static_cast<std::uint32_t>(patch.points.size());
    patch.points.push_back(middle);
    patch.triangles[t] = {a, b, m};
    patch.triangles.push_back({b, c, m});
    patch.triangles.push_back({c, a, m});
    any = true;
  }
  return any;
}

std::vector<std::vector<std::uint32_t>> neighbors_of(const HolePatch& patch) {
  std::vector<std::vector<std::uint32_t>> near(patch.points.size());
  for (const MeshEdge& edge : find_edges(patch.points.size(), patch.triangles).edges) {
    near[edge.low].push_back(edge.high);
    near[edge.high].push_back(edge.low);
  }
  return near;
}

// Least squares: one row a vertex, what it differs from the mean of its neighbors. Border points
// are known; so are the sums `known` over points beyond the border.
class Film {
 public:
  explicit Film(HolePatch& patch)
      : patch_(patch),
        unknowns_(static_cast<Eigen::Index>(patch.points.size() - patch.border)),
        right_(Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(patch.points.size()), 3)) {}

  void add_row(std::uint32_t v, const std::vector<std::uint32_t>& near,
               const std::vector<Vec3>& beyond) {
    const double share = 1 / static_cast<double>(near.size() + beyond.size());
    add(v, v, 1);
    for (const std::uint32_t w : near) add(v, w, -share);
    for (const Vec3& p : beyond) add_known(v, p, -share);
  }

  /// False where that cannot be solved.
  bool prepare() {
    rows_.resize(right_.rows(), unknowns_);
    rows_.setFromTriplets(entries_.begin(), entries_.end());
    const Matrix system = rows_.transpose() * rows_;
    solver_.compute(system);
    return solver_.info() == Eigen::Success;
  }

  /// wanted: per point what it is to differ from the mean of its neighbors by; empty: nothing.
  void solve(const std::vector<Vec3>& wanted) {
    Eigen::MatrixXd right = right_;
    for (std::size_t v = 0; v < wanted.size(); ++v)
      for (std::size_t axis = 0; axis < 3; ++axis)
        right(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(axis)) += wanted[v][axis];
    const Eigen::MatrixXd known = rows_.transpose() * right;
    const Eigen::MatrixXd found = solver_.solve(known);
    if (!found.allFinite()) return;
    for (Eigen::Index i = 0; i < unknowns_; ++i)
      patch_.points[patch_.border + static_cast<std::size_t>(i)] = {found(i, 0), found(i, 1),
                                                                    found(i, 2)};
  }

 private:
  void add(std::uint32_t row, std::uint32_t v, double weight) {
    if (v < patch_.border)
      add_known(row, patch_.points[v], weight);
    else
      entries_.emplace_back(static_cast<int>(row), static_cast<int>(v - patch_.border), weight);
  }
  void add_known(std::uint32_t row, const Vec3& p, double weight) {
    for (Eigen::Index axis = 0; axis < 3; ++axis)
      right_(row, axis) -= weight * p[static_cast<std::size_t>(axis)];
  }

  HolePatch& patch_;
  Eigen::Index unknowns_;
  Entries entries_;
  Eigen::MatrixXd right_;
  Matrix rows_;
  Eigen::SimplicialLDLT<Matrix> solver_;
};

// Of a surface with mean curvature h, a point lies h / 2 times the squared distance of its
// neighbors above their mean.
std::vector<Vec3> wanted_offsets(const HolePatch& patch,
                                 const std::vector<std::vector<std::uint32_t>>& near,
                                 double bending, double longest) {
  std::vector<Vec3> normal(patch.points.size()), wanted(patch.points.size());
  const auto& p = patch.points;
  for (const auto& [a, b, c] : patch.triangles) {
    const Vec3 n = cross(p[b] - p[a], p[c] - p[a]);
    for (const std::uint32_t v : {a, b, c}) normal[v] += n;
  }
  for (std::size_t v = 0; v < p.size(); ++v) {
    double squared = 0;
    for (const std::uint32_t w : near[v]) squared += squared_distance(p[v], p[w]);
    squared /= static_cast<double>(std::max<std::size_t>(near[v].size(), 1));
    wanted[v] = bending / 2 * std::min(squared, longest * longest) * normalized(normal[v]);
  }
  return wanted;
}

}  // namespace

double area(const HolePatch& patch) {
  double sum = 0;
  for (const auto& [a, b, c] : patch.triangles)
    sum += norm(cross(patch.points[b] - patch.points[a], patch.points[c] - patch.points[a])) / 2;
  return sum;
}

void refine(HolePatch& patch, double step) {
  for (int pass = 0; pass < most_passes; ++pass) {
    for (int turn = 0; turn < most_turns && turn_edges(patch); ++turn) {
    }
    if (!insert_middles(patch, step)) break;
  }
}

void relax_film(HolePatch& patch) {
  if (patch.points.size() == patch.border) return;
  const auto near = neighbors_of(patch);
  Film film(patch);
  for (auto v = static_cast<std::uint32_t>(patch.border); v < near.size(); ++v)
    film.add_row(v, near[v], {});
  if (film.prepare()) film.solve({});
}

void relax_plate(HolePatch& patch, const Beyond& beyond, double step) {
  if (patch.points.size() == patch.border) return;
  const auto near = neighbors_of(patch);
  Film film(patch);
  for (std::uint32_t v = 0; v < near.size(); ++v)
    film.add_row(v, near[v], v < patch.border ? beyond.neighbors[v] : std::vector<Vec3>{});
  if (!film.prepare()) return;
  for (int round = 0; round < rounds; ++round)  // the normals follow the shape
    film.solve(wanted_offsets(patch, near, beyond.bending, longest_edge * step));
}

}  // namespace spigolo
