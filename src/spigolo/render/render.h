// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/render.h - a picture of a scene, without a screen
#pragma once

#include <span>
#include <string>

#include "spigolo/core/job.h"
#include "spigolo/render/image.h"
#include "spigolo/render/scene.h"
#include "spigolo/render/view.h"

namespace spigolo {

struct RenderOptions {
  int width = 1600, height = 1200;                         // [pixel] in [16, 16384]
  Color top = background_top, bottom = background_bottom;  // of the background, blended between
  View view;
  double point_size = 1;  // times the automatic size, which just closes the surface; > 0
  int supersampling = 2;  // samples along each side of a pixel, in [1, 4]
  std::string title;      // ASCII
  bool legend = true;     // the scene's legend and colour bar
  bool scale_bar = true;
  bool axes = true;  // a small tripod
};

/// The same pixels for any number of threads. Scenes may be empty. Throws UsageError if the scene
/// does not validate or an option is out of its range.
Image render(const Scene& scene, const RenderOptions& options = {}, const Job& job = {});

struct Panel {
  Scene scene;
  std::string title;
};

/// Panels side by side, in as many rows as fit best, all seen along the first one's direction.
/// options.width and height: of the whole; options.title: over all of it.
Image render_panels(std::span<const Panel> panels, const RenderOptions& options = {},
                    const Job& job = {});

}  // namespace spigolo
