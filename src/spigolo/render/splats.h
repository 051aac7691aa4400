// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/splats.h - points as discs that close up to a surface, and as beads
#pragma once

#include <span>
#include <vector>

#include "spigolo/core/job.h"
#include "spigolo/render/camera.h"
#include "spigolo/render/gbuffer.h"
#include "spigolo/render/scene.h"
#include "spigolo/render/surfels.h"

namespace spigolo {

/// One projected point; not finite or not before the eye: radius 0, never drawn.
struct Splat {
  float x = 0, y = 0, z = 0;
  float radius = 0;                // [pixel] the spacing of the points here, times the layer's size
  float slope_x = 0, slope_y = 0;  // of the disc: depth a pixel [pixel]; 0 faces the eye
  Normal normal{0, 0, 0};          // view space; zero if not known
  Color color;
};

/// Appends one splat per point; without normals they face the eye.
void project_points(std::vector<Splat>& splats, const PointLayer& layer, const Surfels& surfels,
                    const Camera& camera, const Job& job);

/// Draws points as one smooth surface: the nearest disc decides what is seen, then the depths and
/// colours of all points about that near are blended.
void draw_surface(GBuffer& buffer, std::span<const Splat> splats, const Camera& camera,
                  const Job& job);

/// Draws points as balls; one in a surface stands half out of it.
void draw_beads(GBuffer& buffer, std::span<const Splat> splats, const Camera& camera,
                const Job& job);

}  // namespace spigolo
