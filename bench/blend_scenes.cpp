// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/blend_scenes.cpp
#include "blend_scenes.h"

#include <cmath>
#include <filesystem>

#include "report.h"
#include "spigolo/cad/nurbs_shapes.h"
#include "spigolo/io/cloud_file.h"
#include "spigolo/synth/synth.h"

namespace spigolo::bench {
namespace {

const Vec3 ex{1, 0, 0}, ez{0, 0, 1};
constexpr double side = 41;
const Vec3 top{side / 2, side / 2, side};

NurbsFace face_of(NurbsSurface surface) {
  NurbsFace face;
  face.surface = std::move(surface);
  face.u = face.v = {0, 1};
  find_seams(face);
  return face;
}

double axis_distance(const Vec3& p, const Vec3& on_axis, const Vec3& axis) {
  const Vec3 way = p - on_axis;
  return norm(way - axis * dot(way, axis));
}

bool on_top(const Vec3& p) { return p.z > side - 3; }

BlendScene oblique_on_cube(double angle, double radius, double ball) {
  const Vec3 axis{std::cos(radians(angle)), 0, std::sin(radians(angle))};
  BlendScene s{.name = number(angle) + " degrees on the cube",
               .cloud = cube_cloud(),
               .face = face_of(nurbs_tube({top - axis * 10.0, axis}, radius, 37))};
  s.radius = s.height = ball;
  s.enclosed = [=](const Vec3& p) {
    return on_top(p) ? axis_distance(p, top, axis) - radius : infinity;
  };
  return s;
}

BlendScene u_tube() {
  const Vec3 foot = top + Vec3{-10.25, 0, -5};
  BlendScene s{.name = "U tube, both ends inside",
               .cloud = cube_cloud(),
               .face = face_of(nurbs_u_tube({foot, ez}, ex, 4.1, 14, 20.5)),
               .starts = {"v=0.5+", "v=0.5-"}};
  s.enclosed = [=](const Vec3& p) {
    return on_top(p)
               ? std::min(axis_distance(p, foot, ez), axis_distance(p, foot + ex * 20.5, ez)) - 4.1
               : infinity;
  };
  return s;
}

double bean_radius(double t) { return side * (0.16 + 0.07 * std::cos(2 * t) + 0.03 * std::cos(t)); }

BlendScene bean() {
  std::vector<Vec3> profile;
  for (int i = 0; i < 60; ++i) {
    const double t = 2 * pi * i / 60;
    profile.push_back(top + Vec3{bean_radius(t) * std::cos(t), bean_radius(t) * std::sin(t), -5});
  }
  BlendScene s{.name = "bean, not convex",
               .cloud = cube_cloud(),
               .face = face_of(nurbs_extrusion(profile, ez * 20))};
  // Along the ray: not below the true distance by much, and of its sign.
  s.enclosed = [](const Vec3& p) {
    const Vec3 q = p - top;
    return on_top(p) ? (std::hypot(q.x, q.y) - bean_radius(std::atan2(q.y, q.x))) / 2 : infinity;
  };
  return s;
}

std::vector<Vec3> plane_cloud(int nx, int ny) {
  std::vector<Vec3> points;
  for (int i = 0; i < nx; ++i)
    for (int j = 0; j < ny; ++j) points.push_back({double(i), double(j), 0});
  return points;
}

BlendScene slab(double thickness) {
  BlendScene s{.name = "slab, " + number(thickness, 1) + " thick", .cloud = plane_cloud(42, 42)};
  const Vec3 middle{20.5, 20.5, 0};
  for (const Vec3& p : plane_cloud(42, 42)) s.cloud.push_back(p - ez * thickness);
  s.face = face_of(nurbs_tube({middle - ez * (thickness / 2), ez}, 8.2, 20));
  s.radius = s.height = 4;
  s.enclosed = [=](const Vec3& p) {
    return p.z > -0.5 ? axis_distance(p, middle, ez) - 8.2 : infinity;
  };
  return s;
}

double wave(double y) { return 20 + 2 * std::sin(y / 9); }

BlendScene sheet() {
  BlendScene s{.name = "freeform sheet across a plane, one side kept",
               .cloud = plane_cloud(42, 42),
               .face = face_of(nurbs_sheet(41, 20, 12,
                                           [](double x, double y) {
                                             return Vec3{wave(x) + 0.2 * (y - 8), x, y - 8};
                                           })),
               .keep = ex};
  // The wave's slope makes the true distance a little less.
  s.enclosed = [](const Vec3& p) { return 0.97 * (p.x - wave(p.y)); };
  return s;
}

}  // namespace

std::vector<Vec3> cube_cloud(double noise_percent, std::uint64_t seed) {
  SynthOptions options;
  options.sampling = Sampling::lattice;
  options.noise_percent = noise_percent;
  options.seed = seed;
  return make_cloud(options).cloud.points;
}

BlendScene tube_on_cube(double noise_percent, std::uint64_t seed) {
  BlendScene s{.name = "tube on a cube",
               .cloud = cube_cloud(noise_percent, seed),
               .face = face_of(nurbs_tube({top - ez * 8.0, ez}, 8.2, 40))};
  s.radius = s.height = 4;
  s.enclosed = [](const Vec3& p) { return on_top(p) ? axis_distance(p, top, ez) - 8.2 : infinity; };
  return s;
}

BlendScene tube_over_edge() {
  const Vec3 axis = normalized(Vec3{1, 0, 1}), edge{side, side / 2, side};
  BlendScene s{.name = "tube across an edge",
               .cloud = cube_cloud(),
               .face = face_of(nurbs_tube({edge - axis * 16.4, axis}, 8.2, 37))};
  s.radius = s.height = 4;
  s.enclosed = [=](const Vec3& p) {
    return on_top(p) || p.x > side - 3 ? axis_distance(p, edge, axis) - 8.2 : infinity;
  };
  return s;
}

// The vertices of the fandisk and a tube across the sharp edge of its front, there where the wall
// behind it is curved.
BlendScene tube_on_fandisk(const std::string& data) {
  const Vec3 edge{-0.2627, -0.221, 0.2012}, axis = normalized(Vec3{-0.66, -0.985, 0.92});
  return {.name = "fandisk, figure 79",
          .cloud = read_cloud(std::filesystem::path(data) / "fandisk.off").points,
          .face = face_of(nurbs_tube({edge - axis * 0.16, axis}, 0.1, 0.62))};
}

BlendScene oblique_tube(double angle, double radius) {
  const Vec3 axis{std::cos(radians(angle)), 0, std::sin(radians(angle))}, foot{60.3, 40.3, 0};
  const double length = 60 / std::sin(radians(angle)) + 20;
  BlendScene s{.name = number(angle) + " degrees, radius " + number(radius, 1) + ", plane",
               .cloud = plane_cloud(151, 81),
               .face = face_of(nurbs_tube({foot - axis * (length / 2), axis}, radius, length))};
  s.radius = 3, s.height = 3;
  s.enclosed = [=](const Vec3& p) { return axis_distance(p, foot, axis) - radius; };
  return s;
}

std::vector<BlendScene> blend_scenes(const std::string& data) {
  std::vector<BlendScene> scenes = {tube_on_cube(),
                                    tube_over_edge(),
                                    oblique_on_cube(45, 4.9, 3),
                                    oblique_on_cube(30, 3.7, 2),
                                    u_tube(),
                                    bean(),
                                    slab(4.1),
                                    slab(2.1),
                                    sheet()};
  for (const double angle : {60.0, 45.0, 30.0, 20.0, 15.0}) scenes.push_back(oblique_tube(angle));
  for (const double angle : {75.0, 52.0, 37.0, 25.0, 17.0}) {
    scenes.push_back(oblique_tube(angle, 8.7));
    scenes.back().name += ", kept apart";
  }
  scenes.push_back(oblique_tube(33, 6.3));
  scenes.push_back(oblique_tube(18, 12.2));
  for (std::size_t i = scenes.size() - 2; i < scenes.size(); ++i)
    scenes[i].name += ", kept apart from all choices";
  if (!data.empty()) scenes.push_back(tube_on_fandisk(data));
  return scenes;
}

BlendOptions options_of(const BlendScene& scene, BlendMethod method) {
  BlendOptions options;
  options.method = method;
  for (const std::string& start : scene.starts) options.starts.push_back(parse_start(start));
  if (scene.keep != Vec3{}) options.keep = scene.keep;
  if (method == BlendMethod::tangent)
    options.radius = scene.radius;
  else
    options.height = scene.height, options.width = scene.height * std::sqrt(2.0);
  return options;
}

}  // namespace spigolo::bench
