// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/document_pictures.cpp - the pictures of README.md and docs/*.md, and what they show as
// numbers; those of a section of the results are drawn there
#include "blend_pictures.h"
#include "blend_scenes.h"
#include "picture.h"
#include "sections.h"
#include "spigolo/core/random.h"
#include "spigolo/detect/detect.h"
#include "spigolo/pipeline/lines.h"
#include "spigolo/pipeline/mesh.h"
#include "spigolo/pipeline/smooth.h"
#include "spigolo/synth/synth.h"

namespace spigolo::bench {
namespace {

namespace fs = std::filesystem;
using Row = std::vector<std::string>;

constexpr std::uint64_t seed = 5;
constexpr double bead = 0.012;       // of a corner to the size of the picture
constexpr int mesh_colors = 16;      // a wireframe has few colours and many pixels that change
constexpr int small[] = {360, 270};  // [pixel] of a limit's picture

std::vector<Vec3> samples(const char* shape, std::size_t points, double noise, double size = 4,
                          Sampling sampling = Sampling::blue) {
  return make_cloud({.shape = shape,
                     .sampling = sampling,
                     .points = points,
                     .noise = noise,
                     .seed = seed,
                     .size = size})
      .cloud.points;
}

std::string counts_of(const Features& features) {
  const auto counts = features.counts();
  const auto of = [&](PointKind kind) {
    return std::to_string(counts[static_cast<std::size_t>(kind)]);
  };
  return of(PointKind::edge) + " edge, " + of(PointKind::corner) + " corner, " +
         of(PointKind::border) + " border points";
}

std::string counts_of(const MeshedCloud& meshed) {
  const MeshCheck& check = meshed.sharp.check;
  return std::to_string(check.triangles) + " triangles, " +
         (check.closed() ? "closed" : std::to_string(check.border_loops) + " borders") + ", " +
         std::to_string(check.components) + " pieces, " + std::to_string(check.crease_edges_kept) +
         " of " + std::to_string(check.crease_edges) + " crease edges";
}

Panel points_panel(const std::string& title, const std::vector<Vec3>& points) {
  Panel panel{{}, title};
  panel.scene.points.push_back({});
  panel.scene.points.back().points = points;
  return panel;
}

Panel mesh_panel(const std::string& title, const TriangleMesh& mesh, bool wireframe = false) {
  Panel panel{{}, title};
  add_mesh(panel.scene, mesh, false, wireframe);
  return panel;
}

Row labels(const fs::path& folder, const char* name, const std::string& cloud,
           const std::vector<Vec3>& points, const RenderOptions& look) {
  const Detection found = detect(points);
  Scene scene;
  add_points_by_kind(scene, points, found.features.kind);
  save_picture(folder / name, render(scene, look), kept_colors);
  return {name, cloud, std::to_string(points.size()), counts_of(found.features)};
}

Row hole(const fs::path& folder) {
  RenderOptions look = bare_look(560, 420);
  look.legend = look.axes = look.scale_bar = true;
  return labels(folder, "hole.png", "`hole`", make_cloud({.shape = "hole"}).cloud.points, look);
}

Row lines(const fs::path& folder) {
  const std::vector<Vec3> points = samples("l-prism", 10000, 0.25);
  const FeatureCurves network = find_lines(points).network;
  Scene scene = points_panel("", points).scene;
  LineLayer& layer = scene.lines.emplace_back();
  for (const FeatureCurve& curve : network.curves) {
    layer.lines.push_back(curve.points);
    layer.colors.push_back(curve_color(layer.colors.size()));
  }
  PointLayer& corners = scene.points.emplace_back();
  for (const FeatureCorner& corner : network.corners) corners.points.push_back(corner.position);
  corners.color = kind_color(PointKind::corner), corners.style = PointStyle::beads;
  corners.spacing = bead * norm(bounding_box(points).size());
  save_picture(folder / "lines.png", render(scene, bare_look(440, 330)), kept_colors);
  return {"lines.png", "`l-prism`, blue, noise 0.25 h", std::to_string(points.size()),
          std::to_string(network.curves.size()) + " curves, " +
              std::to_string(network.corners.size()) + " corners"};
}

Row mesh(const fs::path& folder) {
  const std::vector<Vec3> points = samples("boxhole", 3000, 0);
  const MeshedCloud meshed = mesh_cloud(points);
  const Panel panels[] = {points_panel("samples", points),
                          mesh_panel("mesh", meshed.sharp.mesh, true)};
  RenderOptions look = bare_look(560, 280, "30,35");
  look.view.target = bounding_box(points).max - Vec3{0.15, 0.65, 0};  // beside the hole
  look.view.radius = 0.3;
  save_picture(folder / "mesh.png", render_panels(panels, look), mesh_colors);
  return {"mesh.png", "`boxhole`, blue", std::to_string(points.size()), counts_of(meshed)};
}

Row projections(const fs::path& folder) {
  const std::vector<Vec3> points = samples("boxhole", 15000, 0.35);
  std::vector<Panel> panels;
  std::string kept;
  for (const auto& [name, method] : {std::pair{"plain", SmoothMethod::plain},
                                     std::pair{"feature-line", SmoothMethod::feature_line},
                                     std::pair{"sheets", SmoothMethod::sheets}}) {
    MeshOptions options;
    options.method = method;
    const MeshedCloud meshed = mesh_cloud(points, options);
    kept += std::string(kept.empty() ? "" : "; ") + name + ": " + counts_of(meshed);
    panels.push_back(mesh_panel(name, meshed.sharp.mesh));
  }
  save_picture(folder / "smooth.png", render_panels(panels, bare_look(570, 190, "30,30")),
               kept_colors);
  return {"smooth.png", "`boxhole`, blue, noise 0.35 h", std::to_string(points.size()), kept};
}

Row thin_walls(const fs::path& folder) {
  const SynthCloud s = make_cloud({.shape = "hole17k", .noise = 0.35, .seed = seed});
  const std::vector<Vec3>& points = s.cloud.points;
  std::vector<Panel> panels = {points_panel("noise .35", points)};
  std::string off;
  for (const auto& [name, method] :
       {std::pair{"plain", SmoothMethod::plain}, std::pair{"sheets", SmoothMethod::sheets}}) {
    SmoothOptions options;
    options.method = method;
    panels.push_back(points_panel(name, smooth(points, options).position));
    double squares = 0;
    for (const Vec3& p : panels.back().scene.points.back().points)
      squares += std::pow(surface_distance(s.shape, p) / s.spacing, 2);
    off += std::string(off.empty() ? "" : ", ") + name + " " +
           number(std::sqrt(squares / double(points.size())), 3);
  }
  save_picture(folder / "smooth-noise.png", render_panels(panels, bare_look(540, 200)),
               mesh_colors);
  return {"smooth-noise.png", "`hole17k`, noise 0.35 h", std::to_string(points.size()),
          "rms from the surface [h]: " + off};
}

Row tube(const fs::path& folder) {
  const BlendScene scene = tube_on_cube();
  BlendOptions options = options_of(scene, BlendMethod::tangent);
  options.radius = 6;
  const Blend blended = blend(scene.cloud, scene.face, options);
  draw_blends({{"", blended}}, folder / "blend.png", 1, 1, 400);
  const BorderReport& border = blended.borders[0];
  return {"blend.png", "`cube` and a tube, R = 6", std::to_string(blended.points.size()),
          std::to_string(border.nurbs_points) + " points of the face, " +
              std::to_string(border.collar_points) + " of the collar"};
}

/// A wall that stands on a floor: T.
std::vector<Vec3> wall_on_floor() {
  constexpr double side = 60, height = 30;
  Random random(seed);
  std::vector<Vec3> points;
  for (int i = 0; i < int(side * side); ++i)
    points.push_back({side * random.uniform(), side * random.uniform(), 0});
  for (int i = 0; i < int(side * height); ++i)
    points.push_back({side / 2, side * random.uniform(), height * random.uniform()});
  return points;
}

Row t_wall(const fs::path& folder) {
  const std::vector<Vec3> points = wall_on_floor();
  const MeshedCloud meshed = mesh_cloud(points);
  Scene scene;
  add_mesh(scene, meshed.sharp.mesh);
  save_picture(folder / "limit-t-wall.png", render(scene, bare_look(small[0], small[1], "30,25")),
               kept_colors);
  return {"limit-t-wall.png", "a wall on a floor, random", std::to_string(points.size()),
          counts_of(meshed)};
}

Row limit(const fs::path& folder, const char* name, const char* shape, std::size_t points,
          double noise, double size, Sampling sampling = Sampling::blue) {
  const std::string cloud = std::string("`") + shape +
                            (sampling == Sampling::blue ? "`, blue" : "`, random") +
                            (noise > 0 ? ", noise " + number(noise, 2) + " h" : "") +
                            (size < 4 ? ", size " + number(size, 1) : "");
  return labels(folder, name, cloud, samples(shape, points, noise, size, sampling),
                bare_look(small[0], small[1]));
}

}  // namespace

void document_pictures(Report& report, const fs::path& pictures) {
  report.heading(2, "Pictures of the documents");
  report.text(
      "What the pictures of README.md and docs/ show; those of a section are named there. Seed 5, "
      "defaults.");
  report.table(
      {"picture", "cloud", "points", "found"},
      {hole(pictures), lines(pictures), mesh(pictures), projections(pictures), thin_walls(pictures),
       tube(pictures), limit(pictures, "limit-noise.png", "box", 3000, 0.75, 4),
       limit(pictures, "limit-strip.png", "chamfer-box", 8000, 0, 1, Sampling::random),
       limit(pictures, "limit-fillet.png", "fillet-box", 8000, 0, 1.5),
       limit(pictures, "limit-obtuse.png", "fade", 6000, 0, 4), t_wall(pictures)});
}

}  // namespace spigolo::bench
