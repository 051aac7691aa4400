// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/meshing.cpp - meshes of raw clouds: closed, manifold, how far from the true surface
#include <algorithm>
#include <ctime>
#include <optional>
#include <string>
#include <vector>

#include "sections.h"
#include "spigolo/core/error.h"
#include "spigolo/measure/distance.h"
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
constexpr const char* open_shapes[] = {"planes", "wedge", "patch", "dome"};
constexpr std::size_t points = 10000;
constexpr std::uint64_t seed = 77;  // none that anything was tuned on

struct Run {
  MeshedCloud meshed;
  DistanceStats to_truth, from_truth, edge;  // [spacings]
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

struct Totals {
  std::size_t runs = 0, closed = 0, sound = 0, euler = 0;
  std::size_t creases = 0, kept = 0, intersections = 0;
};

std::string share(std::size_t part, std::size_t all) {
  return std::to_string(part) + "/" + std::to_string(all);
}

Row solid_row(const Solid& solid, Sampling sampling, const Run& r, Totals& totals) {
  const MeshCheck& check = r.meshed.sharp.check;
  ++totals.runs;
  totals.closed += check.closed();
  totals.sound += check.sound();
  totals.euler += check.euler == solid.euler;
  totals.creases += check.crease_edges;
  totals.kept += check.crease_edges_kept;
  totals.intersections += check.self_intersections;
  return {solid.shape,
          name(sampling),
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
          number(r.edge.max, 3)};
}

const Row solid_head = {"shape",    "sampling",       "closed",       "manifold", "Euler",
                        "contacts", "creases",        "to true mean", "max",      "from true mean",
                        "max",      "true edge mean", "max"};

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
      if (const auto r = run(options)) rows.push_back(solid_row(solid, sampling, *r, totals));
    }
  report.table(solid_head, rows);
  report.text(share(totals.closed, totals.runs) + " closed, " + share(totals.sound, totals.runs) +
              " without any fault, " + share(totals.euler, totals.runs) +
              " with the right Euler number, " + share(totals.kept, totals.creases) +
              " crease edges kept, " + std::to_string(totals.intersections) +
              " self-intersections.");
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

void speed_table(Report& report) {
  std::vector<Row> rows;
  for (const std::size_t n : {std::size_t{100000}, std::size_t{1000000}}) {
    SynthOptions options;
    options.shape = "hole17k";
    options.sampling = Sampling::blue;
    options.points = n;
    options.seed = seed;
    const SynthCloud cloud = make_cloud(options);
    const std::clock_t start = std::clock();
    const MeshedCloud m = mesh_cloud(cloud.cloud.points);
    const double cpu = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    const double wall =
        m.seconds_index + m.seconds_detect + m.seconds_lines + m.seconds_project + m.seconds_mesh;
    rows.push_back({std::to_string(n), std::to_string(m.sharp.check.triangles),
                    m.sharp.check.sound() && m.sharp.check.closed() ? "yes" : "**no**",
                    number(cpu, 1), number(wall, 1), number(m.seconds_project, 1),
                    number(m.seconds_mesh, 1)});
  }
  report.table({"points", "triangles", "closed and sound", "CPU [s]", "wall [s]",
                "of it projection", "mesh"},
               rows);
}

}  // namespace

void meshing(Report& report) {
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
  report.heading(3, "Open surfaces");
  open_table(report);
  report.heading(3, "Speed of a mesh");
  report.text("hole17k, blue, two threads; CPU time of the whole run and wall time.");
  speed_table(report);
}

}  // namespace spigolo::bench
