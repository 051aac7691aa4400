// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/measure/pseudo_normals.cpp - normals of faces, edges and vertices
#include "spigolo/measure/pseudo_normals.h"

#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace spigolo {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// For every vertex the first one (in a sorted order) at the same place.
std::vector<std::uint32_t> weld(const std::vector<Vec3>& vertices) {
  auto key = [&](std::uint32_t v) { return std::tie(vertices[v].x, vertices[v].y, vertices[v].z); };
  std::vector<std::uint32_t> order, same(vertices.size());
  std::iota(same.begin(), same.end(), 0u);
  for (std::uint32_t v = 0; v < vertices.size(); ++v)
    if (is_finite(vertices[v])) order.push_back(v);
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return key(a) != key(b) ? key(a) < key(b) : a < b;
  });
  for (std::size_t i = 1; i < order.size(); ++i)
    if (key(order[i]) == key(order[i - 1])) same[order[i]] = same[order[i - 1]];
  return same;
}

Vec3 face_normal(const std::vector<Vec3>& v, const std::array<std::uint32_t, 3>& t) {
  return normalized(cross(v[t[1]] - v[t[0]], v[t[2]] - v[t[0]]));
}

}  // namespace

PseudoNormals::PseudoNormals(const std::vector<Vec3>& vertices, const Triangles& triangles)
    : normals_(triangles.size()) {
  const std::vector<std::uint32_t> same = weld(vertices);
  std::vector<Vec3> of_vertex(vertices.size());
  std::map<std::pair<std::uint32_t, std::uint32_t>, Vec3> of_edge;
  auto edge_key = [&](const std::array<std::uint32_t, 3>& t, std::size_t i) {
    return std::pair(std::minmax({same[t[i]], same[t[(i + 1) % 3]]}));
  };
  for (const auto& t : triangles) {
    const Vec3 normal = face_normal(vertices, t);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 &a = vertices[t[i]], &b = vertices[t[(i + 1) % 3]], &c = vertices[t[(i + 2) % 3]];
      of_vertex[same[t[i]]] += angle_between(b - a, c - a) * normal;
      of_edge[edge_key(t, i)] += normal;
    }
  }
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    const auto& t = triangles[f];
    normals_[f][0] = face_normal(vertices, t);
    for (std::size_t i = 0; i < 3; ++i) {
      normals_[f][1 + i] = of_edge.at(edge_key(t, i));
      normals_[f][4 + i] = of_vertex[same[t[i]]];
    }
  }
}

const Vec3& PseudoNormals::at(std::size_t triangle, TrianglePart part) const {
  return normals_[triangle][static_cast<std::size_t>(part)];
}

}  // namespace spigolo
