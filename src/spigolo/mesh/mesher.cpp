// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/mesher.cpp - choose vertices, connect them, tell inside from outside, read the
// surface
#include "spigolo/mesh/mesher.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "spigolo/core/error.h"
#include "spigolo/core/stopwatch.h"
#include "spigolo/mesh/caps.h"
#include "spigolo/mesh/flips.h"
#include "spigolo/mesh/handles.h"
#include "spigolo/mesh/leftovers.h"
#include "spigolo/mesh/recover.h"
#include "spigolo/mesh/separate.h"
#include "spigolo/mesh/surfaces.h"
#include "spigolo/mesh/trim.h"

namespace spigolo {
namespace {

constexpr double narrow_hole = 3;  // [edges] across; triangles from border to border will do
constexpr int most_repairs = 8, closing_repairs = 2;
// Times the edge length: other vertices of the same surface may close a torn mesh.
constexpr double other_lengths[] = {0.9, 0.8, 1.2};
constexpr double largest_share_of_faults = 0.15;  // of the triangles and of the points left out
constexpr double no_slip = 0.05;      // the same, where it takes creases along: more than chance
constexpr double most_creases = 0.2;  // share of their edges that is no edge of the mesh: of clean
                                      // surfaces 0.02, of sparse scans and with noise as large as
                                      // the spacing up to 0.2, of points on edges only 0.4

void close_holes(double step, const MesherOptions& options, SharpMesh& result, const Job& job) {
  TriangleMesh& mesh = result.mesh;
  result.holes_filled = fill_holes(mesh.triangles, mesh.vertices.points, narrow_hole * step, job);
  const CapReport caps =
      close_smoothly(mesh, {step, options.close ? infinity : options.largest_hole * step}, job);
  result.holes_filled += caps.smooth + caps.taut;
  result.caps_smooth = caps.smooth, result.caps_taut = caps.taut, result.holes_left = caps.left;
  result.holes_long = caps.too_long;
}

// Tunnels cut and their ends closed, if that succeeds.
void undo_handles(double step, const MesherOptions& options, SharpMesh& result, const Job& job) {
  std::vector<Triangle> rest = result.mesh.triangles;
  const std::size_t cut = cut_handles(rest, result.mesh.vertices.size(), job);
  if (cut == 0) return;
  SharpMesh without = result;
  without.mesh.triangles = std::move(rest);
  separate(without.mesh, without.creases);
  close_holes(step, options, without, job);
  const auto borders = [&](const SharpMesh& m) { return check_connections(m.mesh).border_edges; };
  if (borders(without) > borders(result)) return;
  without.handles_cut = cut;
  without.holes_filled = result.holes_filled, without.holes_left = result.holes_left;
  without.holes_long = result.holes_long;
  without.caps_smooth = result.caps_smooth, without.caps_taut = result.caps_taut;
  result = std::move(without);
}

// Holes closed, triangles of good shape.
void finish(double step, const MesherOptions& options, SharpMesh& result, const Job& job) {
  TriangleMesh& mesh = result.mesh;
  separate(mesh, result.creases);  // makes the loops around holes simple
  close_holes(step, options, result, job);
  undo_handles(step, options, result, job);
  recover_creases(mesh.triangles, mesh.vertices.points, result.creases, job);
  const FlipReport flips = flip_edges(mesh.triangles, mesh.vertices.points, result.creases, job);
  separate(mesh, result.creases);
  result.check = check_connections(mesh, result.creases, job);
  result.check.self_intersections = flips.self_intersections;  // splitting moves nothing
}

// Where the mesh fails its check, triangles go until it passes: rather a hole than a fault. Holes
// are closed again at first, in case that was the fault not any more.
void take_faults_away(double step, const MesherOptions& options, SharpMesh& result,
                      const Job& job) {
  TriangleMesh& mesh = result.mesh;
  for (int round = 0; round < most_repairs && !result.check.sound(); ++round) {
    result.faults_taken += take_faults(mesh.triangles, mesh.vertices.points, job);
    separate(mesh, result.creases);
    if (round < closing_repairs)
      result.holes_filled +=
          fill_holes(mesh.triangles, mesh.vertices.points, options.largest_hole * step, job);
    result.check = check_mesh(mesh, result.creases, job);
  }
}

// More faults and points left out than a surface has, or fewer along with many creases: around
// points on edges only the mesh follows neither.
void refuse_rubble(const SurfacePoints& surface, const SharpMesh& result) {
  const auto share = [](std::size_t part, std::size_t whole) {
    return static_cast<double>(part) / static_cast<double>(std::max<std::size_t>(whole, 1));
  };
  const auto percent = [](double x) { return std::to_string(std::lround(100 * x)) + " %"; };
  const std::size_t left = result.mesh.triangles.size();
  const double faults = share(result.faults_taken, left + result.faults_taken),
               missed = share(result.uncovered, surface.points.size());
  const MeshCheck& check = result.check;
  const double lost = share(check.crease_edges - check.crease_edges_kept, check.crease_edges),
               largest = lost > most_creases ? no_slip : largest_share_of_faults;
  if (left == 0 || faults + missed > largest)
    throw NoResultError(
        "the points do not hold together as a surface: a mesh of them would leave "
        "out " +
        percent(missed) + " of the points and " + percent(lost) + " of the creases, and " +
        percent(faults) +
        " of its triangles would run into each other; is the cloud more than "
        "noise, and are there points on its faces, not on its edges only?");
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

// Its borders are accidents, not the ends of a scan.
bool is_torn(const SharpMesh& mesh) {
  const bool broken = mesh.parts > 1 || mesh.check.components > 1 || mesh.faults_taken > 0 ||
                      mesh.holes_left > mesh.holes_long;
  return broken && !mesh.check.closed();
}

SharpMesh mesh_once(const SurfacePoints& surface, const FeatureCurves& network,
                    const MesherOptions& options, double share, const Job& job) {
  Stopwatch watch;
  SharpMesh result;
  result.length_share = share;
  const EdgeLength edge{surface.spacing * options.edge_length * share,
                        surface.spacing * options.chord_error};
  MeshSamples samples = choose_samples(surface, network, edge, job);
  if (samples.size() < 4) throw NoResultError("fewer than four points on a surface: no mesh");
  result.seconds_samples = watch.lap();
  const double step = samples.step;
  find_surfaces(std::move(samples), surface, result, job);
  finish(step, options, result, job);
  take_faults_away(step, options, result, job);
  result.uncovered =
      count_uncovered(surface, result.mesh.vertices.points, result.mesh.triangles, step);
  return result;
}

}  // namespace

void check_options(const MesherOptions& options) {
  if (!(options.edge_length >= 0.3 && options.edge_length < infinity) ||
      !(options.chord_error >= 0))
    throw UsageError("the edge length of a mesh is at least 0.3 spacings, the chord error 0");
}

SharpMesh build_mesh(const SurfacePoints& surface, const FeatureCurves& network,
                     const MesherOptions& options, const Job& job) {
  check_options(options);
  if (!(surface.spacing > 0)) throw UsageError("the spacing of the points to mesh is not positive");
  Stopwatch watch;
  SharpMesh result = mesh_once(surface, network, options, 1, job);
  const bool at_points_only = !surface.continued;
  for (const double share : other_lengths) {
    if (!at_points_only || !is_torn(result)) break;
    SharpMesh other = mesh_once(surface, network, options, share, job);
    if (other.check.closed() && other.check.sound()) result = std::move(other);
  }
  refuse_rubble(surface, result);
  drop_unused(result);
  result.seconds_total = watch.lap();
  return result;
}

}  // namespace spigolo
