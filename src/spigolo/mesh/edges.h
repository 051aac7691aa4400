// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/edges.h - the edges of a triangle mesh, each with the triangles beside it
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "spigolo/core/job.h"

namespace spigolo {

using Triangle = std::array<std::uint32_t, 3>;

inline constexpr std::uint32_t no_index = 0xffffffffu;

/// Half-edge 3 t + i runs from corner i of triangle t to its next corner.
constexpr std::uint32_t next_half(std::uint32_t half) {
  return half % 3 == 2 ? half - 2 : half + 1;
}

struct MeshEdge {
  std::uint32_t low = 0, high = 0;  // its vertices, low < high
  std::uint32_t begin = 0;          // of its half-edges in EdgeTable::halves
  std::uint32_t count = 0;          // triangles beside it: 1 on a border, 2 inside a surface
};

/// Edges by (low, high); the half-edges of one by number.
struct EdgeTable {
  std::vector<MeshEdge> edges;
  std::vector<std::uint32_t> halves;
  std::vector<std::uint32_t>
      first;  // per vertex, the first edge whose low it is; one more at the end

  std::span<const std::uint32_t> of(const MeshEdge& edge) const {
    return {halves.data() + edge.begin, edge.count};
  }
  /// The edge between two vertices, or null.
  const MeshEdge* find(std::uint32_t a, std::uint32_t b) const;
};

/// vertices: how many there are; every triangle names three different ones.
EdgeTable find_edges(std::size_t vertices, std::span<const Triangle> triangles,
                     const Job& job = {});

/// Per half-edge the one on the other side, no_index on a border or where more than two triangles
/// meet.
std::vector<std::uint32_t> find_twins(const EdgeTable& table, std::size_t triangles);

/// Per corner of the triangles (3 t + i) a number of its fan: corners at one vertex that hang
/// together over edges. The numbers are those of one corner of the fan.
std::vector<std::uint32_t> find_fans(std::span<const Triangle> triangles, const EdgeTable& table);

/// The vertices with more than one fan, ascending.
std::vector<std::uint32_t> find_fan_vertices(std::size_t vertices,
                                             std::span<const Triangle> triangles,
                                             const EdgeTable& table);

}  // namespace spigolo
