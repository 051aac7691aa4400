// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/rivals_mesh.cpp - meshes by ours and others: distance both ways, the true edge, soundness
#include "mesh_close_up.h"
#include "mesh_quality.h"
#include "meshers.h"
#include "meter.h"
#include "picture.h"
#include "plain_search.h"
#include "sections.h"
#include "spigolo/io/cloud_file.h"
#include "truth.h"

namespace spigolo::bench {
namespace {

constexpr const char* kept_shape = "l-prism";  // of the picture that the page shows
constexpr double kept_noise = 0.25;
constexpr int kept_panel = 240;  // [pixel]

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

using Field = double (*)(const MeshQuality&);

/// The entries of all meshers on all clouds, by one figure.
Contest contest_of(const std::vector<Mesher>& all, const std::vector<Answers>& answers,
                   const char* score, Better better, Field field) {
  Contest contest{"Meshes", score, better};
  for (std::size_t c = 0; c < answers[0].size(); ++c) {
    contest.sets.emplace_back();
    for (std::size_t m = 0; m < all.size(); ++m) {
      Entry entry{all[m].name};
      const auto& cloud = answers[m][c];
      if (const auto& q = cloud[one_for_all(answers[m])]) entry.one = field(*q);
      for (const auto& q : cloud)
        if (q && (std::isnan(entry.best) ||
                  (better == Better::lower ? field(*q) < entry.best : field(*q) > entry.best)))
          entry.best = field(*q);
      contest.sets.back().push_back(entry);
    }
  }
  return contest;
}

void enter(Scoreboard& board, const std::vector<Mesher>& all, const std::vector<Answers>& answers) {
  const auto add = [&](const char* score, Better better, Field field) {
    board.add(contest_of(all, answers, score, better, field));
  };
  using Q = const MeshQuality&;
  add("from surface: rms", Better::lower, [](Q q) { return q.from_surface; });
  add("true edge to mesh: mean", Better::lower, [](Q q) { return q.edge; });
  add("normals off near edges [%]", Better::lower, [](Q q) { return q.bad_normals; });
  add("closed and manifold", Better::higher,
      [](Q q) { return q.check.closed() && q.check.manifold() ? 1.0 : 0.0; });
}

/// The clouds, one after another, given to every variant of every mesher.
struct MeshTrial {
  const RivalPlaces& places;
  Scoreboard& board;
  std::vector<Mesher> all = meshers();
  std::vector<Answers> answers = std::vector<Answers>(all.size());
  std::vector<std::vector<std::string>> rows = {};

  /// Returns the meshes by mesher and variant; without triangles where there is none.
  std::vector<std::vector<NamedMesh>> run(const SynthCloud& s, double noise) {
    const SmoothTask task = prepare_task(places, s.cloud.points, {}, mean_spacing(s),
                                         16 + static_cast<int>(64 * noise));
    const double search = search_seconds(task.points, 16);
    std::vector<std::vector<NamedMesh>> meshes(all.size());
    for (std::size_t m = 0; m < all.size(); ++m) {
      answers[m].emplace_back();
      for (const MeshVariant& variant : all[m].variants) {
        const double start = children_seconds();
        answers[m].back().push_back(measure(places, task, variant, s));
        const auto& answer = answers[m].back().back();
        rows.push_back(row_of(s, noise, all[m].name, variant, answer));
        meshes[m].push_back({all[m].name + ", " + variant.name, {}});
        if (!answer) continue;
        board.add_cost(all[m].name, "1", children_seconds() - start, task.points.size(), search);
        meshes[m].back().second = read_mesh(places.file(std::string("mesh") + variant.ending));
      }
    }
    return meshes;
  }
};

void draw_all(const std::vector<std::vector<NamedMesh>>& meshes, const SynthCloud& s,
              const fs::path& file) {
  std::vector<NamedMesh> shown;
  for (const auto& mesher : meshes)
    for (const NamedMesh& mesh : mesher)
      if (!mesh.second.triangles.empty()) shown.push_back(mesh);
  draw_close_up(shown, s, file);
}

/// Each mesher with its one setting, small.
void draw_kept(const MeshTrial& trial, const std::vector<std::vector<NamedMesh>>& meshes,
               const SynthCloud& s, const fs::path& file) {
  std::vector<NamedMesh> shown;
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    const NamedMesh& mesh = meshes[m][one_for_all(trial.answers[m])];
    if (!mesh.second.triangles.empty()) shown.push_back({trial.all[m].name, mesh.second});
  }
  draw_close_up(shown, s, file, kept_panel, kept_colors);
}

}  // namespace

void rivals_mesh(Report& report, const RivalPlaces& places, const MeshPictures& pictures,
                 Scoreboard& board) {
  report.heading(2, "Meshes");
  report.text(
      "8000 samples, seed 71, noise per axis in h, lengths in mean spacings: mesh to the true "
      "surface and back (rms, largest), the true edge to the mesh (mean, largest), percent of the "
      "mesh within 1.5 spacings of an edge whose normal is off by more than 5 degrees. Poisson, "
      "ball pivoting, RIMLS and APSS get normals by CGAL's PCA and spanning tree with k = 16 + 64 "
      "noise neighbors. Every setting that was tried has its row in the second table.");
  MeshTrial trial{places, board};
  std::vector<std::vector<NamedMesh>> kept;
  SynthCloud kept_cloud;
  for (const auto& [shape, sampling] :
       {std::pair{"cylinder-hole", Sampling::blue}, std::pair{"l-prism", Sampling::blue},
        std::pair{"box", Sampling::random}})
    for (const double noise : {0.0, 0.25, 0.5}) {
      const SynthCloud s = make_cloud(
          {.shape = shape, .sampling = sampling, .points = 8000, .noise = noise, .seed = 71});
      auto meshes = trial.run(s, noise);
      draw_all(meshes, s,
               pictures.all / ("mesh-edge-" + s.shape.name + "-" + number(noise, 2) + ".png"));
      if (s.shape.name != kept_shape || noise != kept_noise) continue;
      kept = std::move(meshes);
      kept_cloud = s;
    }
  enter(board, trial.all, trial.answers);
  draw_kept(trial, kept, kept_cloud, pictures.kept / "edge-close-up.png");
  report.text(
      "![One edge of the L-prism, noise 0.25 h, close up: each program's mesh with the true edge "
      "as a line](pictures/edge-close-up.png)");
  report.text(
      "After figures 63 to 65. The same of every cloud and setting is in mesh-edge-*.png among the "
      "pictures that the run leaves on disk.");
  std::vector<std::vector<std::string>> summary;
  for (std::size_t m = 0; m < trial.all.size(); ++m)
    summary.push_back(summary_row(trial.all[m], trial.answers[m]));
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
      trial.rows);
}

}  // namespace spigolo::bench
