// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/blend_meshes.cpp - figures 78 to 80: blends as meshes, sharp where the scan is
#include "blend_meshes.h"

#include "blend_scenes.h"
#include "picture.h"
#include "spigolo/core/error.h"
#include "spigolo/pipeline/blend.h"
#include "spigolo/pipeline/mesh.h"

namespace spigolo::bench {
namespace {

using Row = std::vector<std::string>;
constexpr int panel_width = 280;  // [pixel]

// As `spigolo blend --sharp --mesh` does it.
MeshedCloud mesh_of(const BlendScene& scene) {
  const SharpBlend sharp =
      blend_sharp(scene.cloud, scene.face, options_of(scene, BlendMethod::tangent));
  MeshOptions options;
  options.features = &sharp.features;
  return mesh_cloud(sharp.blend.points, options);
}

Row row_of(const std::string& name, const MeshedCloud& meshed) {
  const SharpMesh& sharp = meshed.sharp;
  const MeshCheck& check = sharp.check;
  return {name,
          std::to_string(sharp.mesh.triangles.size()),
          check.sound() ? "yes" : "**no**",
          std::to_string(check.border_loops),
          std::to_string(check.components),
          std::to_string(check.euler),
          std::to_string(check.crease_edges_kept) + "/" + std::to_string(check.crease_edges),
          std::to_string(sharp.faults_taken)};
}

Panel panel_of(const std::string& name, const MeshedCloud& meshed) {
  Panel panel{{}, name};
  add_mesh(panel.scene, meshed.sharp.mesh);
  return panel;
}

void draw(const std::vector<Panel>& panels, const std::filesystem::path& file) {
  const int width = panel_width * static_cast<int>(panels.size());
  save_picture(file, render_panels(panels, bare_look(width, panel_width, "25,35")), kept_colors);
}

}  // namespace

void blend_meshes(Report& report, const std::string& data, const std::filesystem::path& pictures) {
  report.heading(3, "Figures 78 to 80: meshes of blends");
  report.text(
      "`blend --sharp --mesh`: the tube's far end stays open, so a mesh has one border for each "
      "end that shows.");
  report.text("![Blends as meshes, edges sharp](pictures/blend-mesh.png)");
  std::vector<BlendScene> scenes = {tube_on_cube(), tube_over_edge()};
  if (!data.empty()) scenes.push_back(tube_on_fandisk(data));
  std::vector<Row> rows;
  std::vector<Panel> panels;
  for (const BlendScene& scene : scenes) try {
      const MeshedCloud meshed = mesh_of(scene);
      rows.push_back(row_of(scene.name, meshed));
      panels.push_back(panel_of(scene.name, meshed));
    } catch (const NoResultError& error) {
      rows.push_back({scene.name, std::string("refused: ") + error.what(), "", "", "", "", "", ""});
    }
  if (!panels.empty()) draw(panels, pictures / "blend-mesh.png");
  report.table(
      {"blend", "triangles", "sound", "borders", "pieces", "Euler", "creases", "triangles taken"},
      rows);
}

}  // namespace spigolo::bench
