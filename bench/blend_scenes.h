// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/blend_scenes.h - clouds and faces of chapter 5, with what is known of them exactly
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "spigolo/blend/blend.h"

namespace spigolo::bench {

struct BlendScene {
  std::string name;
  std::vector<Vec3> cloud;
  NurbsFace face{};
  std::vector<std::string> starts = {"v1"};
  Vec3 keep{};        // zero: none
  double radius = 3;  // [spacings] of `tangent`
  double height = 3;  // of `linear`; width is sqrt(2) times that
  /// Distance of a sample to the face's surface, negative where the face encloses it; infinite for
  /// samples of walls that it does not pierce. Empty: not known.
  std::function<double(const Vec3& p)> enclosed{};
};

/// Side 41, spacing 1, as the thesis's cube; noise in percent of the bounding sphere.
std::vector<Vec3> cube_cloud(double noise_percent = 0, std::uint64_t seed = 1);

/// A tube of radius 8.2 that stands on the cube's top; options are those of the sweeps.
BlendScene tube_on_cube(double noise_percent = 0, std::uint64_t seed = 1);
/// One across the cube's edge.
BlendScene tube_over_edge();
/// data: folder with fandisk.off.
BlendScene tube_on_fandisk(const std::string& data);
/// A tube that leaves a wide plane at that angle [degrees].
BlendScene oblique_tube(double angle, double radius = 4.1);
/// All cases of the table; data: folder with fandisk.off, may be empty.
std::vector<BlendScene> blend_scenes(const std::string& data);

BlendOptions options_of(const BlendScene& scene, BlendMethod method);

}  // namespace spigolo::bench
