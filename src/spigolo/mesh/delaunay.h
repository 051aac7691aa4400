// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/delaunay.h - Delaunay tetrahedra of points on a grid, one point after the other
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/mesh/edges.h"
#include "spigolo/mesh/grid.h"

namespace spigolo {

/// Positive: det(v1 - v0, v2 - v0, v3 - v0) > 0.
struct Tetrahedron {
  std::array<std::uint32_t, 4> v;         // vertices; v[0] is no_index in a slot that is free
  std::array<std::uint32_t, 4> neighbor;  // across the facet without v[i]; no_index outside
  bool alive() const { return v[0] != no_index; }
};

/// The corners of the facet opposite to corner i of a positive tetrahedron, counterclockwise as
/// seen from outside of it.
inline constexpr std::array<std::array<std::size_t, 3>, 4> facet_corners = {
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// Insertion after A. Bowyer and D. F. Watson (1981) with exact signs. Vertices 0 to 3 are corners
/// of a tetrahedron around the whole grid; point i becomes vertex i + 4.
class Delaunay {
 public:
  static constexpr std::uint32_t helpers = 4;

  Delaunay();

  /// Inserts points[i] for the given numbers i in rounds of growing size, each in the order given
  /// (along a space-filling curve it is fast). Points at a place taken are left out. points may
  /// grow between calls but not change.
  void insert(std::span<const GridPoint> points, std::span<const std::uint32_t> order,
              const Job& job);

  std::span<const Tetrahedron> tetrahedra() const { return tets_; }
  const GridPoint& point(std::uint32_t vertex) const { return points_[vertex]; }
  std::size_t vertices() const { return points_.size(); }
  bool has(std::uint32_t vertex) const { return vertex < at_.size() && at_[vertex] != no_index; }

  /// All tetrahedra at a vertex, in an order that depends on the points alone.
  void star(std::uint32_t vertex, std::vector<std::uint32_t>& tets) const;
  /// The tetrahedra around an edge; empty if it is none.
  void around(std::uint32_t a, std::uint32_t b, std::vector<std::uint32_t>& tets) const;
  /// Of the star of a vertex, the tetrahedron that a ray from there enters (direction in grid
  /// units).
  std::uint32_t towards(std::uint32_t vertex, const Vec3& direction,
                        std::span<const std::uint32_t> star) const;

 private:
  bool insert_one(std::uint32_t vertex);
  std::uint32_t locate(const GridPoint& p) const;
  void find_cavity(std::uint32_t first, const GridPoint& p);
  bool in_conflict(std::uint32_t t, const GridPoint& p) const;
  bool star_shaped(const GridPoint& p) const;
  void fill_cavity(std::uint32_t vertex);
  std::uint32_t new_slot(std::size_t& reused);

  struct Facet {  // opposite to a corner
    std::uint32_t tet = 0;
    std::uint8_t corner = 0;
  };
  struct Made {  // a tetrahedron to be: corners, neighbor across the rim and where that points back
    std::array<std::uint32_t, 4> v;
    std::uint32_t outside;
    std::uint8_t corner, back;
  };
  struct OpenEdge {  // facet of a new tetrahedron that waits for its neighbor
    std::uint64_t key = 0;
    std::uint32_t stamp = 0;
    Facet facet;
  };
  void link(Facet facet, std::size_t apex);

  std::vector<GridPoint> points_;
  std::vector<Tetrahedron> tets_;
  std::vector<std::uint32_t> at_;    // per vertex, a tetrahedron at it
  std::vector<std::uint32_t> mark_;  // per tetrahedron: 2 stamp in conflict, 2 stamp + 1 not
  std::vector<std::uint32_t> free_, cavity_;
  std::vector<Facet> rim_;
  std::vector<Made> made_;
  std::vector<OpenEdge> open_;  // hash table, its size a power of two
  std::uint32_t stamp_ = 0, open_stamp_ = 0, last_ = 0;
};

}  // namespace spigolo
