// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/polyhedron.cpp - shapes with flat faces
#include "spigolo/synth/polyhedron.h"

#include <map>
#include <utility>

namespace spigolo {
namespace {

constexpr double coplanar = 1e-9;  // [rad] far above rounding, far below any angle we build

struct EdgeUse {
  std::size_t from, to;              // as the first face runs along it
  std::vector<std::size_t> faces{};  // one or two
};

using EdgeMap = std::map<std::pair<std::size_t, std::size_t>, EdgeUse>;

EdgeMap collect_edges(const Polyhedron& polyhedron) {
  EdgeMap edges;
  for (std::size_t f = 0; f < polyhedron.faces.size(); ++f) {
    const auto& face = polyhedron.faces[f];
    for (std::size_t i = 0; i < face.size(); ++i) {
      const std::size_t a = face[i], b = face[(i + 1) % face.size()];
      edges.try_emplace(std::minmax(a, b), EdgeUse{a, b}).first->second.faces.push_back(f);
    }
  }
  return edges;
}

void add_corners(const Polyhedron& polyhedron, const std::vector<int>& valence, Shape& shape) {
  for (std::size_t v = 0; v < valence.size(); ++v)
    if (valence[v] >= 3) shape.corners.push_back({polyhedron.vertices[v], valence[v]});
}

}  // namespace

Shape polyhedron_shape(const std::string& name, const Polyhedron& polyhedron) {
  Shape shape;
  shape.name = name;
  std::vector<Vec3> normals;
  for (const auto& face : polyhedron.faces) {
    std::vector<Vec3> corners;
    for (const std::size_t v : face) corners.push_back(polyhedron.vertices[v]);
    shape.patches.push_back(polygon_patch(corners));
    normals.push_back(polygon_frame(corners).z);
  }
  std::vector<int> valence(polyhedron.vertices.size(), 0);
  for (const auto& [key, edge] : collect_edges(polyhedron)) {
    const Vec3 a = polyhedron.vertices[edge.from], b = polyhedron.vertices[edge.to];
    if (edge.faces.size() == 1) {
      shape.borders.push_back(segment(a, b));
      continue;
    }
    const Vec3 n1 = normals[edge.faces[0]], n2 = normals[edge.faces[1]];
    const double deviation = angle_between(n1, n2);
    if (deviation < coplanar) continue;
    const int convex = dot(cross(n1, n2), b - a) > 0 ? 1 : -1;
    shape.creases.push_back({segment(a, b), constant(deviation), convex});
    ++valence[edge.from], ++valence[edge.to];
  }
  add_corners(polyhedron, valence, shape);
  shape.radius = bounding_radius(polyhedron.vertices);
  return shape;
}

Polyhedron prism(const std::vector<Vec2>& polygon, double z0, double z1) {
  const std::size_t n = polygon.size();
  Polyhedron solid;
  for (const double z : {z0, z1})
    for (const Vec2& c : polygon) solid.vertices.push_back({c.x, c.y, z});
  solid.faces.resize(2);
  for (std::size_t i = 0; i < n; ++i) {
    solid.faces[0].push_back(n - 1 - i);
    solid.faces[1].push_back(n + i);
    solid.faces.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
  }
  return solid;
}

Polyhedron box_polyhedron(const Vec3& min, const Vec3& max) {
  return prism({{min.x, min.y}, {max.x, min.y}, {max.x, max.y}, {min.x, max.y}}, min.z, max.z);
}

Shape drilled_box(const std::string& name, const Vec3& size, double radius) {
  const Vec3 half = size * 0.5;
  const Polyhedron box = box_polyhedron(-half, half);
  Shape shape = polyhedron_shape(name, box);
  const Frame below{{0, 0, -half.z}};
  const Loop outer{
      {{-half.x, -half.y}, {half.x, -half.y}, {half.x, half.y}, {-half.x, half.y}}, {}, 0};
  const Loop rim{{}, {}, radius};
  for (const std::size_t cap : {0u, 1u}) {
    const Frame frame{{0, 0, cap == 0 ? -half.z : half.z}};
    shape.patches[cap] = planar_patch(frame, outer, {rim});
    shape.creases.push_back({circle(frame, radius), constant(half_pi), 1});
  }
  shape.patches.push_back(cylinder_patch(below, radius, size.z));
  return shape;
}

}  // namespace spigolo
