// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/pipeline/mesh.cpp - order and neighbors, creases, points on their sheets, triangles
#include "spigolo/pipeline/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "spigolo/core/error.h"
#include "spigolo/core/parallel.h"
#include "spigolo/core/stopwatch.h"
#include "spigolo/detect/methods.h"
#include "spigolo/mls/sharp.h"
#include "spigolo/pipeline/cone_tips.h"
#include "spigolo/trace/trace.h"

namespace spigolo {
namespace {

constexpr std::size_t grain = 256;
constexpr std::size_t prepared_k = 20;  // neighbors that spacing, noise and labels start from
constexpr double lone = 2.5;            // times the spacing of its neighbors: a flying point
constexpr std::size_t lone_neighbors = 9;
constexpr double disagreement = 0.15;  // [spacings] of sheets continued to one place
constexpr double farthest_move = 1.0;  // [spacings] a point moved farther is on no sheet ...
constexpr double move_by_noise = 4;    // ... plus so many times the noise

std::vector<Vec3> in_input_units(const OrderedCloud& cloud) {
  std::vector<Vec3> points(cloud.points);
  for (Vec3& p : points) p += cloud.origin;
  return points;
}

// Labels in canonical order: given ones, or those of the model.
Features ordered_features(const SheetModel& model, const Features* given) {
  Features features = features_of_model(model);
  const OrderedCloud& cloud = model.prepared.cloud;
  for (Vec3& p : features.crease_point) p += cloud.origin;
  if (given == nullptr) return features;
  for (std::size_t i = 0; i < given->size(); ++i) {
    const std::uint32_t r = cloud.rank[i];
    if (r == no_point) continue;
    features.kind[r] = given->kind[i], features.angle[r] = given->angle[i];
    features.strength[r] = given->strength[i], features.convex[r] = given->convex[i];
    features.crease_point[r] = given->crease_point[i];
    features.direction[r] = given->direction[i], features.sheets[r] = given->sheets[i];
  }
  return features;
}

FeatureCurves find_network(const SheetModel& model, std::span<const Vec3> points,
                           const MeshOptions& options, const Job& job) {
  if (options.network != nullptr) return *options.network;
  if (options.method == SmoothMethod::plain) return {};
  TraceOptions trace;
  trace.spacing = model.prepared.spacing.of_cloud;
  trace.noise = model.prepared.noise;
  return trace_features(points, ordered_features(model, options.features), trace, job).network;
}

// Far from its neighbors, which are near each other.
bool is_lone(const PreparedCloud& prepared, std::size_t i) {
  const auto row = prepared.neighborhoods.of(i);
  const std::size_t n = std::min(row.size(), lone_neighbors);
  std::array<double, lone_neighbors> spacing{};
  for (std::size_t k = 0; k < n; ++k) spacing[k] = prepared.spacing.of_point[row[k]];
  std::nth_element(spacing.begin(), spacing.begin() + n / 2, spacing.begin() + n);
  return n > 0 && prepared.spacing.of_point[i] > lone * spacing[n / 2];
}

double bend(const std::array<double, 2>& curvature) {
  return std::max(std::abs(curvature[0]), std::abs(curvature[1]));
}

SurfaceFoot as_foot(const SurfacePoint& s) {
  if (s.status != SurfaceStatus::sheet) return {};  // creases have vertices of their own
  return {s.position, s.normal, bend(s.curvature)};
}

// The foot of a place near the sheet; its bend is that of the quadric's middle.
SurfaceFoot on_sheet(const Sheet& sheet, const Vec3& query, const Vec3& origin) {
  if (!sheet.fitted()) return {};
  Vec3 p = query - origin, n;
  for (int step = 0; step < 2; ++step) {
    n = normal_at(sheet, p);
    p -= height(sheet, p) * sheet.spacing * n;
  }
  const double mean = std::abs(sheet.a[3] + sheet.a[5]),
               spread = std::hypot(sheet.a[3] - sheet.a[5], sheet.a[4]);
  return {p + origin, n, (mean + spread) / sheet.spacing};
}

SurfacePoints on_sheets(const SharpSurface& surface, MeshedCloud& result, const Job& job) {
  const PreparedCloud& prepared = surface.model().prepared;
  SurfacePoints out;
  out.spacing = prepared.spacing.of_cloud;
  out.points.resize(prepared.cloud.size());
  const double farthest = out.spacing * (farthest_move + move_by_noise * prepared.noise);
  parallel_for(job, "projection", out.points.size(), grain,
               [&](std::size_t begin, std::size_t end) {
                 SheetProbe probe = surface.probe();
                 for (std::size_t i = begin; i < end; ++i) {
                   if (is_lone(prepared, i)) continue;
                   const Vec3 p = prepared.cloud.points[i] + prepared.cloud.origin;
                   SurfaceFoot foot = as_foot(project_sharp(surface, p, probe));
                   foot.spacing = prepared.spacing.of_point[i];
                   if (foot.valid() && distance(foot.position, p) <= farthest) out.points[i] = foot;
                 }
               });
  for (std::size_t i = 0; i < out.points.size(); ++i)
    if (is_lone(prepared, i))
      ++result.outliers;
    else if (!out.points[i].valid())
      out.loose.push_back(prepared.cloud.points[i] + prepared.cloud.origin);
  out.disagreement = out.spacing * (disagreement + prepared.noise);
  // With noise the points around say better than own sheets where the surface goes on: those bend.
  if (!surface.model().tolerances.exact()) return out;
  out.continued = [&surface](std::uint32_t near, const Vec3& query) {
    return on_sheet(surface.model().own[near], query, surface.origin());
  };
  return out;
}

// The thesis's projections; between their points nothing is known of the surface.
SurfacePoints by_neighbors(std::span<const Vec3> points, const MeshOptions& options,
                           const Job& job) {
  SmoothOptions smoothing;
  smoothing.method = options.method;
  smoothing.mls = options.mls;
  const Smoothed smoothed = smooth(points, smoothing, job);
  SurfacePoints out;
  out.spacing = smoothed.spacing;
  out.disagreement = out.spacing * (disagreement + smoothed.noise);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool there = smoothed.status[i] == SurfaceStatus::sheet;
    out.points.push_back(
        there ? SurfaceFoot{smoothed.position[i], smoothed.normal[i], bend(smoothed.curvature[i])}
              : SurfaceFoot{});
  }
  return out;
}

void warn(MeshedCloud& result) {
  const auto say = [&](std::size_t n, const char* text) {
    if (n > 0) result.warnings.push_back(std::to_string(n) + text);
  };
  say(result.non_finite, " points have a NaN or infinite coordinate; they are left out");
  say(result.outliers, " points lie far from all others; they are left out");
  const MeshCheck& check = result.sharp.check;
  if (const double share = result.sharp.length_share; share != 1)
    result.warnings.push_back("edges are " + std::to_string(std::lround(100 * share)) +
                              " % of the length asked for, at which the mesh stayed open");
  say(result.sharp.uncovered,
      " points lie farther than two edges from the mesh; it leaves out a part of the cloud");
  if (result.sharp.parts > 1)
    result.warnings.push_back("the surface is not manifold: " + std::to_string(result.sharp.parts) +
                              " parts that meet or touch are meshed apart");
  say(result.sharp.handles_cut,
      " tunnels or strands only three edges around were taken for noise and cut");
  say(result.sharp.faults_taken,
      " triangles were taken away, since the surface would have run into itself there");
  say(check.nonmanifold_edges + check.nonmanifold_vertices, " places of the mesh are not manifold");
  say(check.self_intersections, " pairs of triangles run into each other");
  say(check.degenerate, " triangles are degenerate");
  say(result.sharp.holes_long, " holes stay open, since more than 2000 edges go around them");
  say(result.sharp.holes_left - result.sharp.holes_long,
      " holes stay open, since whatever closes them would run into the mesh");
  say(check.crease_edges - check.crease_edges_kept, " crease edges are not edges of the mesh");
}

// What is out of range is told before the work begins.
void check(std::span<const Vec3> points, const MeshOptions& options) {
  settle(options.mls, 0);
  check_options(options.mesher);
  if (!(options.sensitivity >= 0 && options.sensitivity <= 1))
    throw UsageError("sensitivity must be between 0 and 1");
  if (options.features != nullptr && options.features->size() != points.size())
    throw UsageError("there are labels for " + std::to_string(options.features->size()) +
                     " points, but the cloud has " + std::to_string(points.size()));
}

}  // namespace

MeshedCloud mesh_cloud(std::span<const Vec3> points, const MeshOptions& options, const Job& job) {
  check(points, options);
  Stopwatch watch;
  MeshedCloud result;
  PreparedCloud prepared = prepare_cloud(points, prepared_k, job);
  result.spacing = prepared.spacing.of_cloud, result.noise = prepared.noise;
  result.duplicates = prepared.cloud.duplicates, result.non_finite = prepared.cloud.non_finite;
  result.seconds_index = watch.lap();
  SheetModel model = build_sheet_model(std::move(prepared), {options.sensitivity}, job);
  result.seconds_detect = watch.lap();
  const std::vector<Vec3> ordered = in_input_units(model.prepared.cloud);
  result.network = find_network(model, ordered, options, job);
  result.seconds_lines = watch.lap();
  std::vector<Vec3> tips;
  if (options.method != SmoothMethod::plain)
    tips = find_cone_tips(ordered, ordered_features(model, options.features), result.network,
                          result.spacing, result.noise);
  const SharpSurface surface(std::move(model), options.mls, job);
  SurfacePoints sheets = options.method == SmoothMethod::sheets
                             ? on_sheets(surface, result, job)
                             : by_neighbors(ordered, options, job);
  sheets.tips = std::move(tips);
  result.seconds_project = watch.lap();
  result.sharp = build_mesh(sheets, result.network, options.mesher, job);
  result.seconds_mesh = watch.lap();
  warn(result);
  return result;
}

}  // namespace spigolo
