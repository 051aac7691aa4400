// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/meshing.cpp - meshes of raw clouds: closed, manifold, how far from the true surface
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "mesh_close_up.h"
#include "meshing_clouds.h"
#include "sections.h"
#include "spigolo/core/error.h"
#include "spigolo/measure/distance.h"
#include "spigolo/mesh/quality.h"
#include "spigolo/pipeline/mesh.h"
#include "spigolo/synth/synth.h"

namespace spigolo::bench {
namespace {

using Row = std::vector<std::string>;

// Closed shapes and the Euler number of their surface.
struct Solid {
  const char* shape;
  long long euler;
};
constexpr Solid solids[] = {
    {"cube", 2},       {"hole17k", 0},       {"box", 2},       {"plate", 2},   {"slot", 2},
    {"l-prism", 2},    {"steps", 2},         {"star", 2},      {"pyramid", 2}, {"boxhole", 0},
    {"cylinder", 2},   {"cylinder-hole", 0}, {"cylinders", 2}, {"cone", 2},    {"lens", 2},
    {"fillet-box", 2}, {"chamfer-box", 2},   {"sphere", 2},    {"torus", 0}};
constexpr const char* open_shapes[] = {"planes", "wedge", "patch", "dome", "cap"};
constexpr std::size_t points = 10000;
constexpr std::uint64_t seed = 77;  // none that anything was tuned on

struct Run {
  MeshedCloud meshed;
  DistanceStats to_truth, from_truth, edge;  // [spacings]
  TriangleQuality quality;
  double sigma = 0;  // [spacings] of the noise, along each axis
};

// Places inside triangles: the surface between vertices is what can err.
std::vector<double> to_surface(const SharpMesh& sharp, const Shape& shape) {
  std::vector<double> distances;
  const auto& p = sharp.mesh.vertices.points;
  for (const auto& [a, b, c] : sharp.mesh.triangles)
    distances.push_back(surface_distance(shape, (p[a] + p[b] + p[c]) / 3));
  return distances;
}

std::vector<Vec3> on_creases(const Shape& shape) {
  constexpr int pieces = 500;
  std::vector<Vec3> places;
  for (const ExactCrease& crease : shape.creases)
    for (int i = 0; i <= pieces; ++i)
      places.push_back(crease.curve.at(static_cast<double>(i) / pieces));
  return places;
}

DistanceStats scaled(DistanceStats stats, double unit) {
  for (double* value : {&stats.mean, &stats.rms, &stats.p95, &stats.max}) *value /= unit;
  return stats;
}

std::optional<Run> run(const SynthOptions& options) {
  const SynthCloud cloud = make_cloud(options);
  Run r;
  try {
    r.meshed = mesh_cloud(cloud.cloud.points);
  } catch (const NoResultError&) {
    return std::nullopt;
  }
  const SharpMesh& sharp = r.meshed.sharp;
  r.quality = measure_quality(sharp.mesh);
  r.sigma = options.noise_percent > 0  // uniform in a ball
                ? options.noise_percent / 100 * cloud.shape.radius / std::sqrt(5.0) / cloud.spacing
                : options.noise;
  r.to_truth = scaled(summarize(to_surface(sharp, cloud.shape)), r.meshed.spacing);
  r.from_truth =
      scaled(summarize(distances_to_mesh(cloud.exact, sharp.mesh, false)), r.meshed.spacing);
  if (const auto places = on_creases(cloud.shape); !places.empty())
    r.edge = scaled(summarize(distances_to_mesh(places, sharp.mesh, false)), r.meshed.spacing);
  return r;
}

const char* name(Sampling sampling) {
  return sampling == Sampling::lattice  ? "lattice"
         : sampling == Sampling::random ? "random"
         : sampling == Sampling::blue   ? "blue"
                                        : "auto";
}

bool has_lattice(const char* shape) {
  const auto all = synth_shapes();
  return std::any_of(all.begin(), all.end(), [&](const ShapeInfo& info) {
    return info.lattice && std::string(info.name) == shape;
  });
}

/// Of all rows of a table.
struct Totals {
  std::size_t runs = 0, closed = 0, sound = 0, euler = 0;
  std::size_t creases = 0, kept = 0, intersections = 0, far = 0;
};

std::string share(std::size_t part, std::size_t all) {
  return std::to_string(part) + "/" + std::to_string(all);
}

Row solid_row(const Solid& solid, const SynthOptions& options, const Run& r, Totals& totals) {
  const MeshCheck& check = r.meshed.sharp.check;
  ++totals.runs;
  totals.closed += check.closed();
  totals.sound += check.sound();
  totals.euler += check.euler == solid.euler;
  totals.creases += check.crease_edges;
  totals.kept += check.crease_edges_kept;
  totals.intersections += check.self_intersections;
  totals.far += r.to_truth.max > 0.15;
  const double sigma = r.sigma;
  const auto shares = [&](double rms) { return sigma > 0 ? number(rms / sigma, 2) : ""; };
  return {solid.shape,
          name(options.sampling),
          check.closed() ? "yes" : "**no**",
          check.manifold() ? "yes" : "**no**",
          check.euler == solid.euler ? std::to_string(check.euler)
                                     : "**" + std::to_string(check.euler) + "**",
          std::to_string(check.self_intersections),
          share(check.crease_edges_kept, check.crease_edges),
          number(r.to_truth.mean, 4),
          number(r.to_truth.max, 3),
          number(r.from_truth.mean, 4),
          number(r.from_truth.max, 3),
          number(r.edge.mean, 4),
          number(r.edge.max, 3),
          shares(r.to_truth.rms),
          shares(r.edge.rms),
          number(degrees(r.quality.angle_mean), 1),
          number(degrees(r.quality.angle_p5), 1)};
}

const Row solid_head = {"shape",
                        "sampling",
                        "closed",
                        "manifold",
                        "Euler",
                        "contacts",
                        "creases",
                        "to true mean",
                        "max",
                        "from true mean",
                        "max",
                        "true edge mean",
                        "max",
                        "rms / noise",
                        "edge rms / noise",
                        "smallest angle mean [deg]",
                        "5 % below"};

Totals closed_table(Report& report, double noise, std::span<const Sampling> samplings) {
  std::vector<Row> rows;
  Totals totals;
  for (const Solid& solid : solids)
    for (const Sampling sampling : samplings) {
      if (sampling == Sampling::lattice && !has_lattice(solid.shape)) continue;
      SynthOptions options;
      options.shape = solid.shape;
      options.sampling = sampling;
      options.points = points;
      options.noise = noise;
      options.seed = seed;
      if (const auto r = run(options)) rows.push_back(solid_row(solid, options, *r, totals));
    }
  report.table(solid_head, rows);
  report.text(share(totals.closed, totals.runs) + " closed, " + share(totals.sound, totals.runs) +
              " without any fault, " + share(totals.euler, totals.runs) +
              " with the right Euler number, " + share(totals.kept, totals.creases) +
              " crease edges kept, " + std::to_string(totals.intersections) +
              " self-intersections, " + share(totals.far, totals.runs) +
              " with a triangle more than .15 off.");
  return totals;
}

void open_table(Report& report) {
  std::vector<Row> rows;
  for (const char* shape : open_shapes)
    for (const Sampling sampling : {Sampling::blue, Sampling::random}) {
      SynthOptions options;
      options.shape = shape;
      options.sampling = sampling;
      options.points = points;
      options.seed = seed;
      const auto r = run(options);
      if (!r) continue;
      const MeshCheck& check = r->meshed.sharp.check;
      rows.push_back({shape, name(sampling), check.sound() ? "yes" : "**no**",
                      std::to_string(check.border_loops), std::to_string(check.euler),
                      share(check.crease_edges_kept, check.crease_edges),
                      number(r->to_truth.mean, 4), number(r->to_truth.max, 3),
                      number(r->from_truth.mean, 4), number(r->from_truth.max, 3)});
    }
  report.table({"shape", "sampling", "sound", "borders", "Euler", "creases", "to true mean", "max",
                "from true mean", "max"},
               rows);
}

// hole17k with the thesis's noise, in percent of its radius.
void thesis_noise_table(Report& report) {
  std::vector<Row> rows;
  Totals totals;
  for (const double percent : {0.0, 0.4, 0.8, 1.6}) {
    SynthOptions options;
    options.shape = "hole17k";
    options.noise_percent = percent;
    options.seed = seed;
    if (const auto r = run(options)) {
      rows.push_back(solid_row({"hole17k", 0}, options, *r, totals));
      rows.back()[0] += " " + number(percent, 1) + " %";
    }
  }
  report.table(solid_head, rows);
}

// One edge of ours, with growing noise.
void close_up(const std::filesystem::path& pictures) {
  std::vector<NamedMesh> meshes;
  SynthCloud cloud;
  for (const double noise : {0.0, 0.25, 0.5}) {
    SynthOptions options;
    options.shape = "l-prism";
    options.points = points;
    options.noise = noise;
    options.sampling = Sampling::blue;
    options.seed = seed;
    cloud = make_cloud(options);
    meshes.push_back({"noise " + number(noise, 2), mesh_cloud(cloud.cloud.points).sharp.mesh});
  }
  draw_close_up(meshes, cloud, pictures / "mesh-edge.png");
}

}  // namespace

void meshing(Report& report, const std::filesystem::path& data,
             const std::filesystem::path& pictures, bool large) {
  constexpr Sampling all[] = {Sampling::lattice, Sampling::blue, Sampling::random};
  constexpr Sampling off_lattice[] = {Sampling::blue, Sampling::random};
  report.heading(2, "Meshes");
  report.text(
      "`spigolo mesh` with its defaults, features and all found in the cloud, 10 000 points, a "
      "seed nothing was tuned on. Lengths in spacings. To true: middles of triangles to the exact "
      "surface; from true: noise-free samples to the mesh; true edge: places on the exact creases "
      "to the mesh.");
  report.heading(3, "Closed shapes without noise");
  closed_table(report, 0, all);
  report.heading(3, "Closed shapes with noise of 0.1 spacings");
  closed_table(report, 0.1, off_lattice);
  report.heading(3, "The thesis's noise");
  thesis_noise_table(report);
  report.heading(3, "Open surfaces");
  open_table(report);
  mesh_clouds(report, data);
  mesh_speed(report, large);
  close_up(pictures);
}

}  // namespace spigolo::bench
