// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/camera.h - from model space to pixels
#pragma once

#include <span>
#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/render/view.h"

namespace spigolo {

/// Pixel coordinates (x right, y down, whole numbers at pixel corners) and the depth along the view
/// [model unit], positive.
struct Projected {
  double x = 0, y = 0, z = 0;
};

struct Camera {
  Vec3 right{1, 0, 0}, up{0, 0, 1}, forward{0, 1, 0};
  Vec3 center;            // in the middle of the scene
  double distance = 1;    // from the eye to the center; larger than the scene's radius
  double scale = 1;       // perspective: pixels at depth 1; orthographic: pixels per model unit
  double cx = 0, cy = 0;  // the pixel of the view axis
  bool perspective = true;

  Projected project(const Vec3& p) const;
  /// The view-space point (x right, y up, z depth) seen at a pixel and depth.
  Vec3 unproject(double x, double y, double z) const;
  /// [model unit] a pixel covers at this depth.
  double pixel_size(double z) const { return perspective ? z / scale : 1 / scale; }
};

/// The part of a picture [pixel] a scene is fitted into.
struct Frame {
  double x0 = 0, y0 = 0, x1 = 1, y1 = 1;
};

/// A camera along `direction` that shows all finite points (or view.target) inside the frame.
/// Scenes without extent get a camera of unit size.
Camera fit_camera(std::span<const std::span<const Vec3>> positions, const View& view,
                  const Vec3& direction, const Frame& frame, const Job& job = {});

}  // namespace spigolo
