// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/mesher.cpp - choose vertices, connect them, tell inside from outside, read the
// surface
#include "spigolo/mesh/mesher.h"

#include <algorithm>
#include <chrono>
#include <numeric>

#include "spigolo/core/error.h"
#include "spigolo/mesh/delaunay.h"
#include "spigolo/mesh/flips.h"
#include "spigolo/mesh/label.h"
#include "spigolo/mesh/recut.h"
#include "spigolo/mesh/relabel.h"
#include "spigolo/mesh/separate.h"
#include "spigolo/mesh/sides.h"
#include "spigolo/mesh/trim.h"

namespace spigolo {
namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

constexpr double jitter_steps = 1e-3;  // what breaks ties between lattice points
constexpr double least_jitter = 2;     // [grid units]
constexpr int split_rounds = 4;
constexpr int most_repairs = 8, closing_repairs = 2;
constexpr double largest_share_of_faults = 0.15;  // of the triangles; with more there is no surface

Delaunay connect(const MeshSamples& samples, const Job& job) {
  const Grid grid = make_grid(bounding_box(samples.position));
  const double jitter = std::max(least_jitter, jitter_steps * samples.step * grid.scale);
  std::vector<GridPoint> points(samples.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i] = grid.place(samples.position[i], jitter, i);
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  Delaunay delaunay;
  delaunay.insert(points, order, job);
  return delaunay;
}

// Segments that are no edges of the tetrahedra.
std::vector<std::size_t> missing_segments(const Delaunay& delaunay, const MeshSamples& samples) {
  std::vector<std::size_t> missing;
  std::vector<std::uint32_t> scratch;
  for (std::size_t s = 0; s < samples.creases.size(); ++s) {
    const std::uint32_t a = samples.creases[s][0] + Delaunay::helpers,
                        b = samples.creases[s][1] + Delaunay::helpers;
    if (!delaunay.has(a) || !delaunay.has(b)) continue;
    delaunay.around(a, b, scratch);
    if (scratch.empty()) missing.push_back(s);
  }
  return missing;
}

// Tetrahedra in which every crease segment is an edge, as far as halving helps.
Delaunay connect_along_creases(MeshSamples& samples, const Job& job) {
  Delaunay delaunay = connect(samples, job);
  for (int round = 0; round < split_rounds; ++round) {
    const auto missing = missing_segments(delaunay, samples);
    if (missing.empty()) break;
    split_creases(samples, missing);
    delaunay = connect(samples, job);
  }
  return delaunay;
}

// The surface between the sides, without what no sample supports.
void read_surface(const Delaunay& delaunay, const MeshSamples& samples, const CreaseSides& sides,
                  const Labelling& labels, SharpMesh& result) {
  result.mesh.vertices.points = samples.position;
  result.mesh.triangles = boundary(delaunay, labels);
  result.creases = samples.creases;
  result.curve = samples.curve;
  trim_unsupported(result.mesh.triangles, samples, Openness(delaunay, samples, sides), {});
}

// Holes closed, triangles of good shape.
void finish(const MeshSamples& samples, const MesherOptions& options, SharpMesh& result,
            const Job& job) {
  TriangleMesh& mesh = result.mesh;
  separate(mesh, result.creases);  // makes the loops around holes simple
  const double largest = options.close ? infinity : options.largest_hole * samples.step;
  result.holes_filled = fill_holes(mesh.triangles, mesh.vertices.points, largest, job);
  const FlipReport flips = flip_edges(mesh.triangles, mesh.vertices.points, result.creases, job);
  separate(mesh, result.creases);
  result.check = check_connections(mesh, result.creases, job);
  result.check.self_intersections = flips.self_intersections;  // splitting moves nothing
}

// Where the mesh fails its check, triangles go until it passes: rather a hole than a fault. Holes
// are closed again at first, in case that was the fault not any more.
void take_faults_away(const MeshSamples& samples, const MesherOptions& options, SharpMesh& result,
                      const Job& job) {
  TriangleMesh& mesh = result.mesh;
  const std::size_t before = mesh.triangles.size();
  for (int round = 0; round < most_repairs && !result.check.sound(); ++round) {
    result.faults_taken += take_faults(mesh.triangles, mesh.vertices.points, job);
    separate(mesh, result.creases);
    if (round < closing_repairs)
      result.holes_filled += fill_holes(mesh.triangles, mesh.vertices.points,
                                        options.largest_hole * samples.step, job);
    result.check = check_mesh(mesh, result.creases, job);
  }
  if (mesh.triangles.empty() || static_cast<double>(result.faults_taken) >
                                    largest_share_of_faults * static_cast<double>(before))
    throw NoResultError(
        "the points do not hold together as a surface: most of what a mesh of them would be runs "
        "into itself; is the cloud more than noise, is it dense enough?");
}

// Vertices that no triangle names, at the end of creases that were not kept, stay: creases name
// them. All others go.
void drop_unused(SharpMesh& result) {
  std::vector<std::uint32_t> number(result.mesh.vertices.size(), no_index);
  for (const Triangle& t : result.mesh.triangles)
    for (const std::uint32_t v : t) number[v] = 0;
  for (const VertexPair& pair : result.creases)
    for (const std::uint32_t v : pair) number[v] = 0;
  std::vector<Vec3>& points = result.mesh.vertices.points;
  std::uint32_t count = 0;
  for (std::size_t v = 0; v < points.size(); ++v) {
    if (number[v] == no_index) continue;
    points[count] = points[v];
    number[v] = count++;
  }
  points.resize(count);
  for (Triangle& t : result.mesh.triangles)
    for (std::uint32_t& v : t) v = number[v];
  for (VertexPair& pair : result.creases)
    for (std::uint32_t& v : pair) v = number[v];
}

}  // namespace

SharpMesh build_mesh(const SurfacePoints& surface, const FeatureCurves& network,
                     const MesherOptions& options, const Job& job) {
  if (!(options.edge_length >= 0.3) || !(options.chord_error >= 0))
    throw UsageError("the edge length of a mesh is at least 0.3 spacings, the chord error 0");
  if (!(surface.spacing > 0)) throw UsageError("the spacing of the points to mesh is not positive");
  const auto start = Clock::now();
  SharpMesh result;
  const EdgeLength edge{surface.spacing * options.edge_length,
                        surface.spacing * options.chord_error};
  MeshSamples samples = choose_samples(surface, network, edge, job);
  if (samples.size() < 4) throw NoResultError("fewer than four points on a surface: no mesh");
  result.seconds_samples = since(start);
  const Delaunay delaunay = connect_along_creases(samples, job);
  result.seconds_tetrahedra = since(start) - result.seconds_samples;
  const CreaseSides sides = find_crease_sides(samples, surface, job);
  Labelling labels = label_tetrahedra(delaunay, samples, sides, job);
  recut_labels(delaunay, samples, sides, labels, job);
  refine_labels(delaunay, samples, sides, labels, job);
  result.seconds_label = since(start) - result.seconds_tetrahedra - result.seconds_samples;
  read_surface(delaunay, samples, sides, labels, result);
  finish(samples, options, result, job);
  take_faults_away(samples, options, result, job);
  result.unused_points = result.mesh.vertices.size() - result.check.vertices;
  drop_unused(result);
  result.seconds_total = since(start);
  return result;
}

}  // namespace spigolo
