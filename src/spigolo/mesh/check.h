// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/check.h - what a triangle mesh is: closed, manifold, oriented, free of contacts
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/core/triangle_mesh.h"
#include "spigolo/mesh/edges.h"

namespace spigolo {

/// Two vertices that a mesh edge should join.
using VertexPair = std::array<std::uint32_t, 2>;

struct MeshCheck {
  std::size_t vertices = 0;  // named by a triangle
  std::size_t edges = 0, triangles = 0;
  std::size_t components = 0;            // joined by shared vertices
  long long euler = 0;                   // vertices - edges + triangles
  std::size_t border_edges = 0;          // with one triangle
  std::size_t border_loops = 0;          // components of those
  std::size_t nonmanifold_edges = 0;     // with more than two
  std::size_t nonmanifold_vertices = 0;  // whose triangles are more than one fan
  std::size_t misoriented_edges = 0;     // of two triangles that both run along it the same way
  std::size_t degenerate = 0;            // triangles flatter than a millionth of their length
  std::size_t self_intersections = 0;    // pairs of triangles, degenerate ones left out
  std::size_t crease_edges = 0;          // asked for
  std::size_t crease_edges_kept = 0;     // that are edges of the mesh
  double area = 0;                       // in squared units of the mesh
  double volume = 0;                     // signed, in cubic units; 0 unless closed

  bool closed() const { return triangles > 0 && border_edges == 0 && nonmanifold_edges == 0; }
  bool manifold() const { return nonmanifold_edges == 0 && nonmanifold_vertices == 0; }
  bool oriented() const { return nonmanifold_edges == 0 && misoriented_edges == 0; }
  /// Closed or with clean borders, it can be worked with.
  bool sound() const {
    return triangles > 0 && manifold() && oriented() && degenerate == 0 && self_intersections == 0;
  }
};

/// A mesh that is valid(); points that are not finite make their triangles degenerate.
/// self-intersections are exact: touching beyond shared corners and edges counts, vertices of equal
/// coordinates are one for that.
MeshCheck check_mesh(const TriangleMesh& mesh, std::span<const VertexPair> creases = {},
                     const Job& job = {});

/// All of it but the self-intersections, which take longest.
MeshCheck check_connections(const TriangleMesh& mesh, std::span<const VertexPair> creases = {},
                            const Job& job = {});

/// Pairs of triangles (a < b) that run into each other, ascending.
std::vector<std::array<std::uint32_t, 2>> find_self_intersections(
    std::span<const Vec3> points, std::span<const Triangle> triangles, const Job& job = {});

/// Flatter than a millionth of its longest edge.
bool is_degenerate(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace spigolo
