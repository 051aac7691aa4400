// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/mesh_quality.cpp
#include "mesh_quality.h"

#include <algorithm>
#include <cmath>

#include "sample_mesh.h"
#include "spigolo/measure/distance.h"
#include "spigolo/synth/sampling.h"
#include "truth.h"

namespace spigolo::bench {
namespace {

constexpr std::size_t samples = 20000;  // of the mesh, of the true surface
constexpr double near_edge = 1.5;       // [mean spacings]
constexpr double bad_normal = 5;        // [deg]

double rms(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v * v;
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(values.size(), 1)));
}

std::vector<double> in_spacings(std::vector<double> values, double spacing) {
  for (double& v : values) v /= spacing;
  return values;
}

double largest(const std::vector<double>& values) {
  return values.empty() ? 0 : *std::max_element(values.begin(), values.end());
}

/// Share of places within near_edge of an edge whose triangle is turned away from the true surface.
double share_of_bad_normals(const TriangleMesh& mesh, const Shape& shape, double spacing) {
  const auto& v = mesh.vertices.points;
  double bad = 0, all = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Vec3 normal = cross(v[b] - v[a], v[c] - v[a]), middle = (v[a] + v[b] + v[c]) / 3;
    const double size = norm(normal);
    if (size == 0 || edge_distance(shape, middle) > near_edge * spacing) continue;
    all += size;
    if (degrees(axial_angle(normal, true_normal(shape, middle))) > bad_normal) bad += size;
  }
  return all > 0 ? 100 * bad / all : 0;
}

}  // namespace

MeshQuality judge(const TriangleMesh& mesh, const SynthCloud& s) {
  const double spacing = mean_spacing(s);
  MeshQuality q;
  std::vector<double> off;
  for (const Vec3& p : sample_mesh(mesh, samples, 1)) off.push_back(surface_distance(s.shape, p));
  off = in_spacings(off, spacing);
  q.to_surface = rms(off), q.to_surface_most = largest(off);
  Random random(2);
  const std::vector<Vec3> surface = sample_random(s.shape, samples, random);
  off = in_spacings(distances_to_mesh(surface, mesh, false), spacing);
  q.from_surface = rms(off), q.from_surface_most = largest(off);
  off = in_spacings(distances_to_mesh(edge_places(s.shape, spacing), mesh, false), spacing);
  q.edge_most = largest(off);
  for (const double d : off) q.edge += d / static_cast<double>(off.size());
  q.bad_normals = share_of_bad_normals(mesh, s.shape, spacing);
  q.check = check_mesh(mesh);
  return q;
}

}  // namespace spigolo::bench
