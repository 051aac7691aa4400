// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/orient.cpp
#include "spigolo/mesh/orient.h"

#include <algorithm>
#include <vector>

#include <array>
#include "spigolo/core/parity_sets.h"
#include "spigolo/mesh/edges.h"
#include "spigolo/mesh/triangle_tree.h"

namespace spigolo {
namespace {

// A piece of the mesh: triangles joined across edges.
struct Piece {
  std::vector<std::uint32_t> triangles;
  Box box;
  Vec3 top{-infinity, -infinity, -infinity};  // its largest vertex by x, y, z
  double volume = 0, area = 0;
  std::size_t turned = 0;
  bool open = false;
};

bool after(const Vec3& a, const Vec3& b) {
  return a.x != b.x ? a.x > b.x : a.y != b.y ? a.y > b.y : a.z > b.z;
}

bool holds(const Box& box, const Vec3& p) { return overlap(box, {p, p}); }

// Solid angle of a triangle (A. van Oosterom, J. Strackee 1983), in [-2 pi, 2 pi].
double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double la = norm(a), lb = norm(b), lc = norm(c);
  return 2 * std::atan2(dot(a, cross(b, c)),
                        la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
}

class Orienter {
 public:
  Orienter(TriangleMesh& mesh, const Job& job)
      : points_(mesh.vertices.points), triangles_(mesh.triangles), sets_(triangles_.size()) {
    join_across_edges(find_edges(points_.size(), triangles_, job));
  }

  OrientReport run() {
    std::vector<char> reverse(pieces_.size(), 0);
    for (std::size_t s = 0; s < pieces_.size(); ++s)
      if (!pieces_[s].triangles.empty()) reverse[s] = looks_inward(pieces_[s]);
    for (std::size_t s = 0; s < pieces_.size(); ++s)
      for (const std::uint32_t t : pieces_[s].triangles)
        if (flip_[t] ^ reverse[s]) {
          std::swap(triangles_[t][1], triangles_[t][2]);
          ++report_.turned;
        }
    return report_;
  }

 private:
  void join_across_edges(const EdgeTable& table) {
    const auto from = [&](std::uint32_t half) { return triangles_[half / 3][half % 3]; };
    for (const MeshEdge& edge : table.edges) {
      if (edge.count != 2) continue;
      const auto halves = table.of(edge);
      const bool same_way = from(halves[0]) == from(halves[1]);
      if (!sets_.join(halves[0] / 3, halves[1] / 3, same_way ? 1 : 0)) ++report_.not_orientable;
    }
    pieces_.resize(triangles_.size());
    flip_.resize(triangles_.size());
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      const auto [set, parity] = sets_.find(t);
      flip_[t] = static_cast<char>(parity);
      pieces_[set].turned += parity;
      pieces_[set].triangles.push_back(t);
    }
    for (const MeshEdge& edge : table.edges)
      if (edge.count != 2) pieces_[sets_.find(table.of(edge)[0] / 3).set].open = true;
    for (Piece& piece : pieces_) measure(piece);
  }

  void measure(Piece& piece) const {
    for (const std::uint32_t t : piece.triangles)
      for (const std::uint32_t v : triangles_[t]) {
        piece.box.add(points_[v]);
        if (after(points_[v], piece.top)) piece.top = points_[v];
      }
    for (const std::uint32_t t : piece.triangles) {
      const auto [a, b, c] = corners(t, piece.box.center());
      piece.volume += dot(a, cross(b, c)) / 6;
      piece.area += norm(cross(b - a, c - a)) / 2;
    }
  }

  // Corners relative to a place, in the order that all triangles of the piece agree on.
  std::array<Vec3, 3> corners(std::uint32_t t, const Vec3& origin) const {
    const auto [i, j, k] = triangles_[t];
    const Vec3 a = points_[i] - origin, b = points_[j] - origin, c = points_[k] - origin;
    return flip_[t] ? std::array<Vec3, 3>{a, c, b} : std::array<Vec3, 3>{a, b, c};
  }

  bool looks_inward(const Piece& piece) const {
    const bool flat = std::abs(piece.volume) <= 1e-6 * std::pow(piece.area, 1.5);
    if (flat) return 2 * piece.turned > piece.triangles.size();
    bool inward = piece.volume < 0;
    if (piece.open) return inward;
    for (const Piece& other : pieces_)
      if (&other != &piece && !other.triangles.empty() && !other.open &&
          holds(other.box, piece.top) && surrounds(other, piece.top))
        inward = !inward;
    return inward;
  }

  // The triangles of a closed piece fill the whole sphere as seen from inside.
  bool surrounds(const Piece& piece, const Vec3& p) const {
    double sum = 0;
    for (const std::uint32_t t : piece.triangles) {
      const auto [a, b, c] = corners(t, p);
      sum += solid_angle(a, b, c);
    }
    return std::abs(sum) > 2 * pi;
  }

  const std::vector<Vec3>& points_;
  std::vector<Triangle>& triangles_;
  ParitySets sets_;
  std::vector<Piece> pieces_;  // by the set's root; empty elsewhere
  std::vector<char> flip_;     // per triangle: runs against the first of its piece
  OrientReport report_;
};

}  // namespace

OrientReport orient_mesh(TriangleMesh& mesh, const Job& job) { return Orienter(mesh, job).run(); }

}  // namespace spigolo
