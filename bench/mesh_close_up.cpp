// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/mesh_close_up.cpp
#include "mesh_close_up.h"

#include "picture.h"

namespace spigolo::bench {
namespace {

constexpr double reach = 7;  // [spacings] shown around the place
constexpr int line_pieces = 200;

// Triangles around a place only: the rest would set the size of the view.
TriangleMesh around(const TriangleMesh& mesh, const Vec3& place, double radius) {
  TriangleMesh part;
  part.vertices.points = mesh.vertices.points;
  for (const auto& t : mesh.triangles) {
    bool near = true;
    for (const std::uint32_t v : t) near &= distance(mesh.vertices.points[v], place) < radius;
    if (near) part.triangles.push_back(t);
  }
  return part;
}

}  // namespace

void draw_close_up(const std::vector<NamedMesh>& meshes, const SynthCloud& cloud,
                   const std::filesystem::path& file, int panel_width, int colors) {
  if (meshes.empty() || cloud.shape.creases.empty()) return;
  const Curve& curve = cloud.shape.creases.front().curve;
  const Vec3 place = curve.at(0.37);
  const double radius = reach * cloud.spacing;
  LineLayer truth;
  truth.lines.emplace_back();
  truth.width = 2;
  for (int i = 0; i <= line_pieces; ++i) {
    const Vec3 p = curve.at(static_cast<double>(i) / line_pieces);
    if (distance(p, place) < radius) truth.lines.back().push_back(p);
  }
  std::vector<Panel> panels;
  for (const auto& [name, mesh] : meshes) {
    Panel panel{{}, name};
    add_mesh(panel.scene, around(mesh, place, 2 * radius), false, colors == 0);
    panel.scene.lines.push_back(truth);
    panels.push_back(std::move(panel));
  }
  const int columns = panels.size() > 3 ? 3 : static_cast<int>(panels.size());
  const int rows = (static_cast<int>(panels.size()) + columns - 1) / columns;
  RenderOptions options = bare_look(panel_width * columns, panel_width * rows);
  options.view.target = place;
  options.view.radius = radius;
  save_picture(file, render_panels(panels, options), colors);
}

}  // namespace spigolo::bench
