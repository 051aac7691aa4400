// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/blend_pictures.cpp
#include "blend_pictures.h"

#include "picture.h"

namespace spigolo::bench {
namespace {

constexpr Color cloud_color{214, 217, 222}, face_color{150, 180, 214}, collar_color{240, 165, 80};

Color color_of(BlendSource source) {
  return source == BlendSource::cloud   ? cloud_color
         : source == BlendSource::nurbs ? face_color
                                        : collar_color;
}

Scene scene_of(const Blend& blend) {
  PointLayer layer;
  layer.points = blend.points;
  for (const BlendSource source : blend.source) layer.colors.push_back(color_of(source));
  layer.spacing = blend.spacing;
  Scene scene;
  scene.points.push_back(std::move(layer));
  return scene;
}

}  // namespace

void draw_blends(const std::vector<PictureOf>& blends, const std::filesystem::path& file, int rows,
                 int columns, int panel_width) {
  std::vector<Panel> panels;
  for (const PictureOf& one : blends) panels.push_back({scene_of(one.blend), one.title});
  if (panels.empty()) return;
  RenderOptions options = bare_look(panel_width * columns, panel_width * rows, "25,35");
  options.view.target = Vec3{20.5, 20.5, 46};
  options.view.radius = 21;
  save_picture(file, render_panels(panels, options), kept_colors);
}

}  // namespace spigolo::bench
