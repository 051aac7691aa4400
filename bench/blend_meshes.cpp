// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/blend_meshes.cpp - figures 78 to 80: blends as meshes, sharp where the scan is
#include "blend_meshes.h"

#include "blend_scenes.h"
#include "spigolo/core/error.h"
#include "spigolo/io/atomic_file.h"
#include "spigolo/pipeline/blend.h"
#include "spigolo/pipeline/mesh.h"
#include "spigolo/render/render.h"

namespace spigolo::bench {
namespace {

using Row = std::vector<std::string>;
constexpr int panel_width = 400;  // [pixel]

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
  add_mesh(panel.scene, meshed.sharp.mesh, false, true);
  return panel;
}

void draw(const std::vector<Panel>& panels, const std::filesystem::path& file) {
  RenderOptions options;
  options.width = panel_width * static_cast<int>(panels.size()), options.height = panel_width;
  options.view.direction = parse_view_direction("25,35");
  options.axes = options.scale_bar = options.legend = false;
  const std::vector<std::byte> png = encode_png(render_panels(panels, options));
  std::filesystem::create_directories(file.parent_path());
  AtomicFile out(file);
  out.write({reinterpret_cast<const char*>(png.data()), png.size()});
  out.commit();
}

}  // namespace

void blend_meshes(Report& report, const std::string& data, const std::filesystem::path& pictures) {
  report.heading(3, "Figures 78 to 80: meshes of blends");
  report.text(
      "`blend --sharp --mesh`: the tube's far end stays open, so a mesh has one border for each "
      "end that shows. Pictures: pictures/blend-mesh-1.png and so on.");
  std::vector<BlendScene> scenes = {tube_on_cube(), tube_over_edge()};
  if (!data.empty()) scenes.push_back(tube_on_fandisk(data));
  std::vector<Row> rows;
  for (const BlendScene& scene : scenes) try {
      const MeshedCloud meshed = mesh_of(scene);
      rows.push_back(row_of(scene.name, meshed));
      draw({panel_of(scene.name, meshed)},
           pictures / ("blend-mesh-" + std::to_string(rows.size()) + ".png"));
    } catch (const NoResultError& error) {
      rows.push_back({scene.name, std::string("refused: ") + error.what(), "", "", "", "", "", ""});
    }
  report.table(
      {"blend", "triangles", "sound", "borders", "pieces", "Euler", "creases", "triangles taken"},
      rows);
}

}  // namespace spigolo::bench
