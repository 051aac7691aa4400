// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/meshers.cpp
#include "meshers.h"

#include "report.h"

namespace spigolo::bench {
namespace {

MeshVariant open3d(const std::string& mode, int depth) {
  return {depth > 0 ? "depth " + std::to_string(depth) : "radii .75 to 2.5", ".off",
          [=](const RivalPlaces& places, const SmoothTask& task, const std::string& out) {
            return run_rival(
                places, {"/usr/bin/python3", (places.scripts / "open3d_mesh.py").string(), mode,
                         places.file("oriented.xyz").string(), out, number(task.spacing, 12),
                         std::to_string(depth)});
          }};
}

MeshVariant cgal_poisson(double radius, double distance) {
  return {"radius " + number(radius) + ", distance " + number(distance, 3), ".off",
          [=](const RivalPlaces& places, const SmoothTask& task, const std::string& out) {
            return run_rival(
                places,
                {places.program("cgal_mesh"), "poisson", places.file("oriented.xyz").string(), out,
                 number(task.spacing, 12), number(radius, 3), number(distance, 3)});
          }};
}

MeshVariant advancing_front() {
  return {"no setting", ".off",
          [](const RivalPlaces& places, const SmoothTask&, const std::string& out) {
            return run_rival(places, {places.program("cgal_mesh"), "advancing-front",
                                      places.file("cloud.xyz").string(), out});
          }};
}

/// own: the parameters that only this one of the two filters has.
MeshVariant marching_cubes(const std::string& filter, double scale, const std::string& own) {
  const std::string script = "<filter name=\"Marching Cubes (" + filter + ")\">\n" +
                             filter_parameter("FilterScale", "RichFloat", number(scale, 2)) +
                             filter_parameter("ProjectionAccuracy", "RichFloat", "0.0001") +
                             filter_parameter("MaxProjectionIters", "RichInt", "15") + own +
                             filter_parameter("Resolution", "RichInt", "150") + "</filter>\n";
  return {"filter scale " + number(scale), ".ply",
          [script](const RivalPlaces& places, const SmoothTask&, const std::string& out) {
            return run_meshlab(places, {places.file("oriented.xyz")}, out, script);
          }};
}

MeshVariant rimls(double scale) { return marching_cubes("RIMLS", scale, rimls_parameters()); }

MeshVariant apss(double scale) { return marching_cubes("APSS", scale, apss_parameters()); }

MeshVariant ours() {
  return {"defaults", ".ply",
          [](const RivalPlaces& places, const SmoothTask&, const std::string& out) {
            return run_rival(places, {places.spigolo, "mesh", places.file("cloud.xyz").string(),
                                      "-o", out, "--quiet"});
          }};
}

}  // namespace

std::vector<Mesher> meshers() {
  return {{"`mesh`", {ours()}},
          {"CGAL advancing front", {advancing_front()}},
          {"CGAL Poisson", {cgal_poisson(30, 0.375), cgal_poisson(2, 0.1)}},
          {"Open3D Poisson", {open3d("poisson", 6), open3d("poisson", 7), open3d("poisson", 8)}},
          {"Open3D ball pivoting", {open3d("ball-pivoting", 0)}},
          {"MeshLab RIMLS marching cubes", {rimls(2), rimls(3)}},
          {"MeshLab APSS marching cubes", {apss(2), apss(3)}}};
}

}  // namespace spigolo::bench
