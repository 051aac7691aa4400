// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/blend/scenes.h - clouds and faces that meet
#pragma once

#include <cmath>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "spigolo/blend/blend.h"
#include "spigolo/cad/nurbs_shapes.h"
#include "spigolo/core/random.h"
#include "spigolo/synth/synth.h"

namespace spigolo::test {

inline const Vec3 ex{1, 0, 0}, ey{0, 1, 0}, ez{0, 0, 1};

inline NurbsFace face_of(NurbsSurface surface) {
  NurbsFace face;
  face.surface = std::move(surface);
  face.u = face.v = {0, 1};
  find_seams(face);
  return face;
}

/// The cube of the thesis: corner at the origin, side 41, spacing 1 (42 samples an edge).
inline std::vector<Vec3> cube(Sampling sampling = Sampling::lattice, double noise_percent = 0,
                              std::uint64_t seed = 1) {
  SynthOptions options;
  options.sampling = sampling;
  options.points = sampling == Sampling::lattice ? 0 : 10088;
  options.noise_percent = noise_percent;
  options.seed = seed;
  return make_cloud(options).cloud.points;
}

/// Square lattice of spacing 1 in the plane z = 0, [0, n - 1] both ways.
inline std::vector<Vec3> plane(int nx, int ny) {
  std::vector<Vec3> points;
  for (int i = 0; i < nx; ++i)
    for (int j = 0; j < ny; ++j) points.push_back({double(i), double(j), 0});
  return points;
}
inline std::vector<Vec3> plane(int n) { return plane(n, n); }

/// Tube of radius 8 that stands on the middle of the cube's top and goes 8 down into it.
inline NurbsFace top_tube(double length = 28) {
  return face_of(nurbs_tube({{20.5, 20.5, 33}, ez}, 8, length));
}

inline BlendOptions from(std::initializer_list<const char*> starts, double radius = 4) {
  BlendOptions options;
  for (const char* start : starts) options.starts.push_back(parse_start(start));
  options.radius = radius;
  return options;
}

inline std::vector<Vec3> shuffled(std::vector<Vec3> points, std::uint64_t seed) {
  Random random(seed);
  for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[random.below(i)]);
  return points;
}

inline std::vector<Vec3> points_of(const Blend& blend, BlendSource source) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < blend.points.size(); ++i)
    if (blend.source[i] == source) points.push_back(blend.points[i]);
  return points;
}

}  // namespace spigolo::test
