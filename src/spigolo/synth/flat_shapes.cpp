// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/flat_shapes.cpp - shapes with flat faces, and the box with rounded edges
#include "spigolo/core/error.h"
#include "spigolo/synth/catalogue.h"
#include "spigolo/synth/lattice.h"
#include "spigolo/synth/polyhedron.h"
#include "spigolo/synth/ridge.h"

namespace spigolo {
namespace {

constexpr Vec3 box_size{1, 0.8, 0.6};
constexpr std::size_t usual_points = 10000;

/// options.size in units of the shape: it depends on the area, and the area on it.
double in_units(const SynthOptions& options, double largest,
                const std::function<double(double size)>& area_of) {
  const auto n = static_cast<double>(options.points > 0 ? options.points : usual_points);
  double size = 0;
  for (int i = 0; i < 50; ++i)
    size = options.size * std::sqrt(area_of(std::min(size, largest)) / n);
  if (!(size < largest))
    throw UsageError("the size does not fit into shape '" + options.shape +
                     "'; take a smaller one or more points");
  return size;
}

/// A shape whose lattice is that of cells of side `unit`.
Construction of_cells(const Shape& shape, const CellSolid& cells, double unit,
                      const SynthOptions& options) {
  const std::size_t faces = surface_faces(cells);
  auto total = [faces](std::size_t steps) { return faces * steps * steps + 2; };
  const std::size_t usual = nearest_count(usual_points, 0, total);
  const std::size_t steps = nearest_count(options.points, usual, total);
  auto lattice = [=] { return surface_lattice(cells, static_cast<int>(steps), unit); };
  return {shape, lattice, usual_points};
}

/// Faces of a box with all edges cut off by c, given the box's half sides.
Polyhedron chamfered_box(const Vec3& half, double c) {
  Polyhedron result;
  // vertex 3 * corner + axis: next to the corner, on the face across the axis
  for (std::size_t corner = 0; corner < 8; ++corner)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Vec3 p;
      for (std::size_t a = 0; a < 3; ++a)
        p[a] = ((corner >> a & 1) != 0 ? 1 : -1) * (a == axis ? half[a] : half[a] - c);
      result.vertices.push_back(p);
    }
  auto add = [&](std::vector<std::size_t> face) {
    Vec3 middle, normal;
    for (std::size_t i = 0; i < face.size(); ++i) middle += result.vertices[face[i]];
    for (std::size_t i = 0; i < face.size(); ++i)
      normal += cross(result.vertices[face[i]], result.vertices[face[(i + 1) % face.size()]]);
    if (dot(normal, middle) < 0) std::reverse(face.begin(), face.end());
    result.faces.push_back(face);
  };
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t b = 1u << (a + 1) % 3, d = 1u << (a + 2) % 3, up = 1u << a;
    for (const std::size_t o : {std::size_t{0}, up})
      add({3 * o + a, 3 * (o + b) + a, 3 * (o + b + d) + a, 3 * (o + d) + a});
    const std::size_t e = (a + 1) % 3, f = (a + 2) % 3;  // the edges along axis a, and their faces
    for (const std::size_t o : {std::size_t{0}, b, d, b + d})
      add({3 * o + e, 3 * (o + up) + e, 3 * (o + up) + f, 3 * o + f});
  }
  for (std::size_t corner = 0; corner < 8; ++corner)
    add({3 * corner, 3 * corner + 1, 3 * corner + 2});
  return result;
}

Frame mirrored(const Vec3& origin, const Vec3& sign) {
  return {origin, {sign.x, 0, 0}, {0, sign.y, 0}, {0, 0, sign.z}};
}

/// A box with all edges and corners rounded: no crease at all.
Shape rounded_box(const Vec3& half, double r) {
  Shape shape;
  shape.name = "fillet-box";
  const Vec3 flat = half - r * Vec3{1, 1, 1};
  const Vec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
    const Loop face{
        {{-flat[b], -flat[c]}, {flat[b], -flat[c]}, {flat[b], flat[c]}, {-flat[b], flat[c]}},
        {},
        0};
    for (const int s : {-1, 1}) {
      shape.patches.push_back(
          planar_patch({s * half[a] * axes[a], axes[b], axes[c], axes[a]}, face));
      for (const int t : {-1, 1}) {
        const Vec3 start = s * flat[b] * axes[b] + t * flat[c] * axes[c] - flat[a] * axes[a];
        const Frame edge{start, s * axes[b], t * axes[c], axes[a]};
        shape.patches.push_back(cylinder_patch(edge, r, 2 * flat[a], half_pi));
      }
    }
  }
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 sign{corner & 1 ? 1.0 : -1.0, corner & 2 ? 1.0 : -1.0, corner & 4 ? 1.0 : -1.0};
    const Vec3 at{sign.x * flat.x, sign.y * flat.y, sign.z * flat.z};
    shape.patches.push_back(octant_patch(mirrored(at, sign), r));
  }
  shape.radius = norm(flat) + r;
  return shape;
}

Shape slotted_block(double width) {
  const double left = 0.5 - width / 2, right = 0.5 + width / 2;
  return polyhedron_shape("slot", prism({{0, 0},
                                         {1, 0},
                                         {1, 0.6},
                                         {right, 0.6},
                                         {right, 0.2},
                                         {left, 0.2},
                                         {left, 0.6},
                                         {0, 0.6}},
                                        0, 0.8));
}

}  // namespace

Construction make_box(const SynthOptions& options) {
  return of_cells(polyhedron_shape("box", box_polyhedron({}, box_size)), block(5, 4, 3), 0.2,
                  options);
}

Construction make_plate(const SynthOptions& options) {
  const double thickness = in_units(options, 0.8, [](double t) { return 2 * (0.8 + t + 0.8 * t); });
  return {polyhedron_shape("plate", box_polyhedron({}, {1, 0.8, thickness})), {}, usual_points};
}

Construction make_slot(const SynthOptions& options) {
  const double width = in_units(options, 0.8, [](double w) { return area(slotted_block(w)); });
  return {slotted_block(width), {}, usual_points};
}

Construction make_fillet_box(const SynthOptions& options) {
  const Vec3 half = box_size * 0.5;
  const double r = in_units(options, half.z, [&](double x) { return area(rounded_box(half, x)); });
  return {rounded_box(half, r), {}, usual_points};
}

Construction make_chamfer_box(const SynthOptions& options) {
  const Vec3 half = box_size * 0.5;
  auto shape = [&](double c) { return polyhedron_shape("chamfer-box", chamfered_box(half, c)); };
  auto area_of = [&](double c) { return area(shape(std::max(c, 1e-6))); };
  return {shape(in_units(options, half.z, area_of)), {}, usual_points};
}

Construction make_l_prism(const SynthOptions& options) {
  const Polyhedron solid = prism({{0, 0}, {1, 0}, {1, 0.5}, {0.5, 0.5}, {0.5, 1}, {0, 1}}, 0, 0.5);
  const CellSolid cells{2, 2, 1, [](int i, int j, int) { return i == 0 || j == 0; }};
  return of_cells(polyhedron_shape("l-prism", solid), cells, 0.5, options);
}

Construction make_steps(const SynthOptions& options) {
  const Polyhedron solid = prism({{0, 0},
                                  {0.75, 0},
                                  {0.75, 0.25},
                                  {0.5, 0.25},
                                  {0.5, 0.5},
                                  {0.25, 0.5},
                                  {0.25, 0.75},
                                  {0, 0.75}},
                                 0, 0.75);
  const CellSolid cells{3, 3, 3, [](int i, int j, int) { return i + j < 3; }};
  return of_cells(polyhedron_shape("steps", solid), cells, 0.25, options);
}

Construction make_star(const SynthOptions&) {
  std::vector<Vec2> outline;
  for (int i = 0; i < 10; ++i) {
    const double r = i % 2 == 0 ? 1 : 0.5, a = i * pi / 5;
    outline.push_back({r * std::cos(a), r * std::sin(a)});
  }
  return {polyhedron_shape("star", prism(outline, 0, 0.5)), {}, usual_points};
}

Construction make_pyramid(const SynthOptions& options) {
  if (options.sides < 3 || options.sides > 12) throw UsageError("a pyramid has 3 to 12 sides");
  Polyhedron solid;
  std::vector<std::size_t> base;
  const std::size_t n = options.sides;
  for (std::size_t i = 0; i < n; ++i) {
    const double a = 2 * pi * (static_cast<double>(i) + 0.5) / static_cast<double>(n);
    const double x = std::sqrt(0.5) * std::cos(a), y = std::sqrt(0.5) * std::sin(a);
    solid.vertices.push_back({0.5 + x, 0.5 + y, 0});
    base.push_back(n - 1 - i);
    solid.faces.push_back({i, (i + 1) % n, n});
  }
  solid.vertices.push_back({0.5, 0.5, 0.7});
  solid.faces.insert(solid.faces.begin(), base);
  return {polyhedron_shape("pyramid", solid), {}, usual_points};
}

Construction make_fade(const SynthOptions& options) {
  check_angle(options);
  return {ridge_shape("fade", {1, 0.3, options.angle, pi}), {}, usual_points};
}

}  // namespace spigolo
