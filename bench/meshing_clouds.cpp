// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/meshing_clouds.cpp
#include "meshing_clouds.h"

#include <algorithm>
#include <string>
#include <vector>

#include "meter.h"
#include "spigolo/core/error.h"
#include "spigolo/io/cloud_file.h"
#include "spigolo/measure/distance.h"
#include "spigolo/pipeline/mesh.h"
#include "spigolo/synth/synth.h"

namespace spigolo::bench {
namespace {

namespace fs = std::filesystem;
using Row = std::vector<std::string>;

constexpr std::uint64_t seed = 77;  // none that anything was tuned on
constexpr double covered = 1.5;     // [spacings] a point farther from the mesh is not covered

std::string share(std::size_t part, std::size_t all) {
  return std::to_string(part) + "/" + std::to_string(all);
}

// Without truth: soundness, and how far the cloud lies from the mesh.
Row cloud_row(const std::string& name, const std::vector<Vec3>& points) {
  MeshedCloud m;
  const Meter meter;
  try {
    m = mesh_cloud(points);
  } catch (const NoResultError&) {
    return {name, std::to_string(points.size()), "refused", "", "", "", "", "", "", "", "", ""};
  }
  const double cpu = meter.cpu();
  std::vector<double> off = distances_to_mesh(points, m.sharp.mesh, false);
  for (double& d : off) d /= m.spacing;
  const auto far = std::count_if(off.begin(), off.end(), [](double d) { return d > covered; });
  const DistanceStats stats = summarize(off);
  const MeshCheck& check = m.sharp.check;
  return {name,
          std::to_string(points.size()),
          check.closed() ? "yes" : std::to_string(check.border_loops) + " borders",
          check.sound() ? "yes" : "**no**",
          std::to_string(check.euler),
          std::to_string(check.components),
          share(check.crease_edges_kept, check.crease_edges),
          std::to_string(m.sharp.faults_taken),
          std::to_string(far),
          number(stats.mean, 4),
          number(stats.max, 2),
          number(cpu, 1)};
}

const Row cloud_head = {"cloud",
                        "points",
                        "closed",
                        "sound",
                        "Euler",
                        "pieces",
                        "creases",
                        "triangles taken",
                        "points not covered",
                        "cloud to mesh mean",
                        "max",
                        "CPU [s]"};

void scans(Report& report) {
  report.heading(3, "Meshes of simulated scans");
  report.text(
      "What two scanners see of closed shapes, 10 000 points: the rest is open. A mesh keeps those "
      "borders; nothing bridges what was not seen.");
  std::vector<Row> rows;
  for (const char* shape : {"box", "l-prism", "boxhole", "cylinders"}) {
    SynthOptions options{
        .shape = shape, .sampling = Sampling::view, .points = 10000, .seed = seed, .views = 2};
    rows.push_back(cloud_row(shape, make_cloud(options).cloud.points));
  }
  report.table(cloud_head, rows);
}

}  // namespace

void mesh_clouds(Report& report, const fs::path& data) {
  scans(report);
  if (data.empty()) return;
  report.heading(3, "Meshes of models and of ABC clouds");
  report.text(
      "Vertices of published meshes (uneven, partly on the edges) and the clean ABC clouds, whose "
      "narrow parts are one or two spacings wide. Not covered: points farther than 1.5 spacings "
      "from the mesh.");
  std::vector<fs::path> files;
  for (const char* file : {"fandisk.off", "fandisk_large.off", "aimatshape/fandisk.ply",
                           "aimatshape/trim-star.ply", "anchor_dense.off", "couplingdown.off"})
    if (fs::exists(data / file)) files.push_back(data / file);
  std::vector<fs::path> abc;
  if (fs::exists(data / "abc/clean"))
    for (const auto& entry : fs::directory_iterator(data / "abc/clean"))
      if (entry.path().extension() == ".ply") abc.push_back(entry.path());
  std::sort(abc.begin(), abc.end());
  files.insert(files.end(), abc.begin(), abc.end());
  std::vector<Row> rows;
  for (const fs::path& file : files)
    rows.push_back(cloud_row(file.stem().string(), read_cloud(file).points));
  report.table(cloud_head, rows);
}

void mesh_speed(Report& report, bool large) {
  report.heading(3, "Speed of a mesh");
  report.text(
      "hole17k, blue, two threads: CPU time and wall time from points to mesh, and the memory "
      "above "
      "that of the points. A million points only with --large.");
  std::vector<Row> rows;
  std::vector<std::size_t> sizes = {100000};
  if (large) sizes.push_back(1000000);
  for (const std::size_t n : sizes) {
    SynthOptions options{.shape = "hole17k", .sampling = Sampling::blue, .points = n, .seed = seed};
    const std::vector<Vec3> points = make_cloud(options).cloud.points;
    const Meter meter;
    const MeshedCloud m = mesh_cloud(points);
    const double cpu = meter.cpu(), wall = meter.wall(),
                 bytes = static_cast<double>(meter.peak_bytes()) / static_cast<double>(n);
    rows.push_back({std::to_string(n), std::to_string(m.sharp.check.triangles),
                    m.sharp.check.sound() && m.sharp.check.closed() ? "yes" : "**no**",
                    number(cpu, 1), number(wall, 1), number(m.seconds_project, 1),
                    number(m.seconds_mesh, 1), number(bytes)});
  }
  report.table({"points", "triangles", "closed and sound", "CPU [s]", "wall [s]",
                "of it projection", "mesh", "bytes a point"},
               rows);
}

}  // namespace spigolo::bench
