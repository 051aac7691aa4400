// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/rivals_mesh.cpp - meshes by ours and others: distance both ways, the true edge, soundness
#include "mesh_close_up.h"
#include "sample_mesh.h"
#include "sections.h"
#include "smoothers.h"
#include "spigolo/io/cloud_file.h"
#include "spigolo/measure/distance.h"
#include "spigolo/mesh/check.h"
#include "spigolo/synth/sampling.h"
#include "truth.h"

namespace spigolo::bench {
namespace {

constexpr std::size_t samples = 20000;  // of the mesh, of the true surface
constexpr double near_edge = 1.5;       // [mean spacings]
constexpr double bad_normal = 5;        // [deg]

/// Writes a mesh of the task's cloud to a file with that ending.
struct MeshVariant {
  std::string name;
  const char* ending;
  std::function<bool(const RivalPlaces&, const SmoothTask&, const std::string& out)> run;
};

struct Mesher {
  std::string name;
  std::vector<MeshVariant> variants;
};

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

MeshVariant marching_cubes(double scale) {
  const std::string script = "<filter name=\"Marching Cubes (RIMLS)\">\n" +
                             filter_parameter("FilterScale", "RichFloat", number(scale, 2)) +
                             filter_parameter("ProjectionAccuracy", "RichFloat", "0.0001") +
                             filter_parameter("MaxProjectionIters", "RichInt", "15") +
                             filter_parameter("SigmaN", "RichFloat", "0.75") +
                             filter_parameter("MaxRefittingIters", "RichInt", "3") +
                             filter_parameter("Resolution", "RichInt", "150") + "</filter>\n";
  return {"filter scale " + number(scale), ".ply",
          [script](const RivalPlaces& places, const SmoothTask&, const std::string& out) {
            return run_meshlab(places, {places.file("oriented.xyz")}, out, script);
          }};
}

MeshVariant ours() {
  return {"defaults", ".ply",
          [](const RivalPlaces& places, const SmoothTask&, const std::string& out) {
            return run_rival(places, {places.spigolo, "mesh", places.file("cloud.xyz").string(),
                                      "-o", out, "--quiet"});
          }};
}

std::vector<Mesher> meshers() {
  return {{"`mesh`", {ours()}},
          {"CGAL advancing front", {advancing_front()}},
          {"CGAL Poisson", {cgal_poisson(30, 0.375), cgal_poisson(2, 0.1)}},
          {"Open3D Poisson", {open3d("poisson", 6), open3d("poisson", 7), open3d("poisson", 8)}},
          {"Open3D ball pivoting", {open3d("ball-pivoting", 0)}},
          {"MeshLab RIMLS marching cubes", {marching_cubes(2), marching_cubes(3)}}};
}

struct MeshQuality {
  double to_surface = 0, to_surface_most = 0;  // [spacings] rms and largest
  double from_surface = 0, from_surface_most = 0;
  double edge = 0, edge_most = 0;  // true edge to the mesh, mean and largest
  double bad_normals = 0;          // [%] of the mesh near edges, off by more than 5 degrees
  MeshCheck check;
};

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

std::optional<MeshQuality> measure(const RivalPlaces& places, const SmoothTask& task,
                                   const MeshVariant& variant, const SynthCloud& s) {
  const fs::path out = places.file(std::string("mesh") + variant.ending);
  fs::remove(out);
  if (!variant.run(places, task, out.string()) || !fs::exists(out)) return std::nullopt;
  try {
    const TriangleMesh mesh = read_mesh(out);
    if (mesh.triangles.empty()) return std::nullopt;
    return judge(mesh, s);
  } catch (const std::exception&) {
    return std::nullopt;  // an empty or odd file is no answer
  }
}

std::string soundness(const MeshCheck& c) {
  std::string text = c.closed() ? "closed" : std::to_string(c.border_edges) + " border edges";
  if (!c.manifold())
    text += ", " + std::to_string(c.nonmanifold_edges + c.nonmanifold_vertices) + " not manifold";
  if (c.self_intersections > 0)
    text += ", " + std::to_string(c.self_intersections) + " self-intersections";
  if (c.components > 1) text += ", " + std::to_string(c.components) + " pieces";
  return text;
}

std::vector<std::string> row_of(const SynthCloud& s, double noise, const std::string& name,
                                const MeshVariant& variant, const std::optional<MeshQuality>& q) {
  std::vector<std::string> row = {s.shape.name, number(noise, 2), name, variant.name};
  if (!q) {
    row.insert(row.end(), {"did not run", "", "", "", "", "", "", "", ""});
    return row;
  }
  row.insert(row.end(), {std::to_string(q->check.triangles), number(q->to_surface, 3),
                         number(q->to_surface_most, 2), number(q->from_surface, 3),
                         number(q->from_surface_most, 2), number(q->edge, 3),
                         number(q->edge_most, 2), number(q->bad_normals, 1), soundness(q->check)});
  return row;
}

/// What the variants of one mesher gave, cloud by cloud.
using Answers = std::vector<std::vector<std::optional<MeshQuality>>>;

double distance_of(const std::optional<MeshQuality>& q) {
  return q ? q->from_surface : infinity;  // a mesh that is not there is no setting for all
}

/// The variant with the smallest distance over all clouds.
std::size_t one_for_all(const Answers& answers) {
  std::size_t best = 0;
  double least = infinity;
  for (std::size_t v = 0; v < answers[0].size(); ++v) {
    double sum = 0;
    for (const auto& cloud : answers) sum += distance_of(cloud[v]);
    if (sum < least) least = sum, best = v;
  }
  return best;
}

std::vector<std::string> summary_row(const Mesher& mesher, const Answers& answers) {
  const std::size_t one = one_for_all(answers);
  MeshQuality sum;
  double best = 0, count = 0;
  std::size_t closed = 0;
  for (const auto& cloud : answers) {
    double least = infinity;
    for (const auto& q : cloud) least = std::min(least, distance_of(q));
    best += least;
    if (!cloud[one]) continue;
    const MeshQuality& q = *cloud[one];
    sum.to_surface += q.to_surface, sum.from_surface += q.from_surface, sum.edge += q.edge;
    sum.bad_normals += q.bad_normals;
    closed += q.check.closed() && q.check.manifold();
    count += 1;
  }
  if (count == 0) return {mesher.name, "did not run", "", "", "", "", "", ""};
  const auto all = static_cast<double>(answers.size());
  return {mesher.name,
          mesher.variants[one].name,
          number(sum.to_surface / count, 3),
          number(sum.from_surface / count, 3),
          number(sum.edge / count, 3),
          number(sum.bad_normals / count, 1),
          std::to_string(closed) + " of " + std::to_string(answers.size()),
          std::isfinite(best) ? number(best / all, 3) : "-"};
}

}  // namespace

void rivals_mesh(Report& report, const RivalPlaces& places, const fs::path& pictures) {
  report.heading(2, "Meshes");
  report.text(
      "8000 samples, seed 71, noise per axis in h, lengths in mean spacings: mesh to the true "
      "surface and back (rms, largest), the true edge to the mesh (mean, largest), percent of the "
      "mesh within 1.5 spacings of an edge whose normal is off by more than 5 degrees. Poisson, "
      "ball pivoting and RIMLS get normals by CGAL's PCA and spanning tree with k = 16 + 64 noise "
      "neighbors. Every setting that was tried has its row in the second table. One edge close up "
      "by all of them "
      "is in mesh-edge-*.png among the pictures.");
  const std::vector<Mesher> all = meshers();
  std::vector<Answers> answers(all.size());
  std::vector<std::vector<std::string>> rows, summary;
  for (const auto& [shape, sampling] :
       {std::pair{"cylinder-hole", Sampling::blue}, std::pair{"l-prism", Sampling::blue},
        std::pair{"box", Sampling::random}})
    for (const double noise : {0.0, 0.25, 0.5}) {
      const SynthCloud s = make_cloud(
          {.shape = shape, .sampling = sampling, .points = 8000, .noise = noise, .seed = 71});
      const SmoothTask task = prepare_task(places, s.cloud.points, {}, mean_spacing(s),
                                           16 + static_cast<int>(64 * noise));
      std::vector<NamedMesh> close_ups;
      for (std::size_t m = 0; m < all.size(); ++m) {
        answers[m].emplace_back();
        for (const MeshVariant& variant : all[m].variants) {
          answers[m].back().push_back(measure(places, task, variant, s));
          rows.push_back(row_of(s, noise, all[m].name, variant, answers[m].back().back()));
          if (answers[m].back().back())
            close_ups.push_back({all[m].name + ", " + variant.name,
                                 read_mesh(places.file(std::string("mesh") + variant.ending))});
        }
      }
      draw_close_up(close_ups, s,
                    pictures / ("mesh-edge-" + s.shape.name + "-" + number(noise, 2) + ".png"));
    }
  for (std::size_t m = 0; m < all.size(); ++m) summary.push_back(summary_row(all[m], answers[m]));
  report.text(
      "One setting for all clouds, the one with the smallest mean rms from the surface, chosen "
      "with the truth; figures are means over the clouds; last, the mean of its best for each "
      "cloud, chosen the same way:");
  report.table({"program", "one setting", "to surface: rms", "from surface: rms", "edge: mean",
                "normals off [%]", "closed and manifold", "best per cloud: from surface"},
               summary);
  report.text("Cloud by cloud:");
  report.table(
      {"shape", "noise", "program", "setting", "triangles", "to surface: rms", "largest",
       "from surface: rms", "largest", "edge: mean", "largest", "normals off [%]", "soundness"},
      rows);
}

}  // namespace spigolo::bench
