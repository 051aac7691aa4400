// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/rivals_smooth.cpp - projected points: how near to the true surface, how sharp
#include <array>

#include "meter.h"
#include "plain_search.h"
#include "sections.h"
#include "smoothers.h"
#include "spigolo/measure/distance.h"
#include "truth.h"

namespace spigolo::bench {
namespace {

constexpr const char* upsampling = "CGAL edge-aware upsampling";
constexpr double upsampling_radii[] = {2, 3, 4};      // [mean spacings]
constexpr double near_edge = 3;                       // [mean spacings]
constexpr double normal_from = 0.1, normal_to = 1.5;  // [mean spacings] from the edge

struct Quality {
  double rms = 0, near = 0;      // [spacings] to the true surface: all, within 3 of an edge
  double normal = not_a_number;  // [deg] mean, .1 to 1.5 spacings from an edge
  double gap = not_a_number, most = not_a_number;  // [spacings] true edge to surface: mean, max
};

class Judge {
 public:
  explicit Judge(const SynthCloud& s) : s_(s), spacing_(mean_spacing(s)) {
    for (const Vec3& p : s.exact) {
      edge_.push_back(edge_distance(s.shape, p) / spacing_);
      normals_.push_back(true_normal(s.shape, p));
    }
  }

  Quality operator()(const SmoothTask& task, const Projected& result) const {
    Quality q;
    double sum = 0, near = 0, near_count = 0, angle = 0, angles = 0;
    for (std::size_t i = 0; i < edge_.size(); ++i) {
      const double d = surface_distance(s_.shape, result.points.points[i]) / spacing_;
      sum += d * d;
      if (edge_[i] <= near_edge) near += d * d, near_count += 1;
      const Vec3& n = result.points.normals[i];
      if (edge_[i] < normal_from || edge_[i] > normal_to || squared_norm(n) == 0) continue;
      angle += degrees(axial_angle(n, normals_[i])), angles += 1;
    }
    q.rms = std::sqrt(sum / static_cast<double>(edge_.size()));
    q.near = std::sqrt(near / std::max(1.0, near_count));
    if (angles > 0) q.normal = angle / angles;
    add_gap(task, result, q);
    return q;
  }

 private:
  void add_gap(const SmoothTask& task, const Projected& result, Quality& q) const {
    if (result.queries.empty()) return;
    q.gap = q.most = 0;
    for (std::size_t i = 0; i < result.queries.size(); ++i) {
      const double d = distance(result.queries[i], task.queries[i]) / spacing_;
      q.gap += d / static_cast<double>(result.queries.size());
      q.most = std::max(q.most, d);
    }
  }

  const SynthCloud& s_;
  double spacing_;
  std::vector<double> edge_;  // [mean spacings] of the exact samples
  std::vector<Vec3> normals_;
};

/// CGAL's edge-aware resampling makes new points, four times as many. gap: of the places on the
/// true edge to the nearest of them, half of whose distance no resampling can avoid.
std::optional<Quality> judge_upsampling(const RivalPlaces& places, const SmoothTask& task,
                                        const Shape& shape, double radius) {
  const fs::path out = places.file("upsampled.xyz");
  fs::remove(out);
  if (!task.oriented || !run_rival(places, {places.program("cgal_points"), "upsample",
                                            places.file("oriented.xyz").string(), out.string(),
                                            "25", number(radius * task.spacing, 12),
                                            std::to_string(4 * task.points.size())}))
    return std::nullopt;
  const auto rows = read_xyz(out);
  if (!rows || rows->points.empty()) return std::nullopt;
  Quality q;
  double sum = 0, near = 0, near_count = 0;
  for (const Vec3& p : rows->points) {
    const double d = surface_distance(shape, p) / task.spacing;
    sum += d * d;
    if (edge_distance(shape, p) <= near_edge * task.spacing) near += d * d, near_count += 1;
  }
  q.rms = std::sqrt(sum / static_cast<double>(rows->points.size()));
  q.near = std::sqrt(near / std::max(1.0, near_count));
  const DistanceStats gap = summarize(distances_to_points(task.queries, rows->points));
  q.gap = gap.mean / task.spacing, q.most = gap.max / task.spacing;
  return q;
}

std::string text(double value, int digits) {
  return std::isnan(value) ? "-" : number(value, digits);
}

using Qualities = std::vector<std::optional<Quality>>;  // by variant

struct Cell {
  std::string shape, noise;
  std::vector<Qualities> of;  // by smoother
  Qualities upsampled = {};   // by radius
};

SynthCloud cloud_of(const char* shape, Sampling sampling, double noise) {
  return make_cloud(
      {.shape = shape, .sampling = sampling, .points = 8000, .noise = noise, .seed = 61});
}

Cell measure(const RivalPlaces& places, const std::vector<Smoother>& all, const SynthCloud& s,
             double noise, Scoreboard& board) {
  const double spacing = mean_spacing(s);
  const SmoothTask task = prepare_task(places, s.cloud.points, edge_places(s.shape, spacing),
                                       spacing, 16 + static_cast<int>(64 * noise));
  const Judge judge(s);
  Cell cell{s.shape.name, number(noise, 2), {}};
  const double search = search_seconds(task.points, 16);
  const auto timed = [&](const std::string& name, const auto& run) {
    const double start = children_seconds();
    auto result = run();
    if (result) board.add_cost(name, "1", children_seconds() - start, task.points.size(), search);
    return result;
  };
  for (const double radius : upsampling_radii)
    cell.upsampled.push_back(
        timed(upsampling, [&] { return judge_upsampling(places, task, s.shape, radius); }));
  for (const Smoother& smoother : all) {
    cell.of.emplace_back();
    for (const SmoothVariant& variant : smoother.variants) {
      const auto result = timed(smoother.name, [&] { return variant.run(places, task); });
      cell.of.back().push_back(result ? std::optional(judge(task, *result)) : std::nullopt);
    }
  }
  return cell;
}

/// The variant with the smallest mean distance near edges over all cells it has answered.
/// of: what one program gave, cell by cell.
std::size_t one_for_all(const std::vector<const Qualities*>& of) {
  std::size_t best = 0;
  double least = infinity;
  for (std::size_t v = 0; v < of[0]->size(); ++v) {
    double sum = 0;
    for (const Qualities* cell : of) sum += (*cell)[v] ? (*cell)[v]->near : 10;
    if (sum < least) least = sum, best = v;
  }
  return best;
}

std::vector<std::string> figures_of(const Quality& q) {
  return {number(q.rms, 3), number(q.near, 3), text(q.normal, 1), text(q.gap, 3), text(q.most, 2)};
}

/// One program over all cells: the names of its settings, and what they gave.
struct Contender {
  std::string name;
  std::vector<std::string> settings;
  std::vector<const Qualities*> of;
  std::size_t one = 0;
};

std::vector<Contender> contenders(const std::vector<Cell>& cells,
                                  const std::vector<Smoother>& smoothers) {
  std::vector<Contender> all;
  for (std::size_t i = 0; i < smoothers.size(); ++i) {
    all.push_back({smoothers[i].name, {}, {}});
    for (const SmoothVariant& v : smoothers[i].variants) all.back().settings.push_back(v.name);
    for (const Cell& cell : cells) all.back().of.push_back(&cell.of[i]);
  }
  all.push_back({upsampling, {}, {}});
  for (const double radius : upsampling_radii)
    all.back().settings.push_back("25 deg, radius " + number(radius) + ", x 4");
  for (const Cell& cell : cells) all.back().of.push_back(&cell.upsampled);
  for (Contender& c : all) c.one = one_for_all(c.of);
  return all;
}

std::vector<std::string> row_of(const Cell& cell, const Contender& contender, std::size_t at) {
  std::vector<std::string> row = {cell.shape, cell.noise, contender.name,
                                  contender.settings[contender.one]};
  const Qualities& all = *contender.of[at];
  if (!all[contender.one]) {
    row.insert(row.end(), {"did not run", "", "", "", "", ""});
    return row;
  }
  double best = infinity;
  std::string best_name;
  for (std::size_t v = 0; v < all.size(); ++v)
    if (all[v] && all[v]->near < best) best = all[v]->near, best_name = contender.settings[v];
  const std::vector<std::string> figures = figures_of(*all[contender.one]);
  row.insert(row.end(), figures.begin(), figures.end());
  row.push_back(all.size() > 1 ? number(best, 3) + " (" + best_name + ")" : "");
  return row;
}

Contest contest_of(const std::vector<Contender>& all, const char* score, double Quality::*field) {
  Contest contest{"Smoothing", score, Better::lower};
  for (std::size_t at = 0; at < all[0].of.size(); ++at) {
    contest.sets.emplace_back();
    for (const Contender& c : all) {
      Entry entry{c.name};
      const Qualities& of = *c.of[at];
      if (of[c.one]) entry.one = (*of[c.one]).*field;
      for (const auto& q : of)
        if (q && !((*q).*field >= entry.best)) entry.best = (*q).*field;
      contest.sets.back().push_back(entry);
    }
  }
  return contest;
}

}  // namespace

void rivals_smooth(Report& report, const RivalPlaces& places, Scoreboard& board) {
  report.heading(2, "Smoothing");
  report.text(
      "Every point projected; 8000 samples, seed 61, noise per axis in h, lengths in mean spacings "
      "sqrt(area / points). rms: projected points to the true surface, all and those within 3 "
      "spacings of an edge; normal: mean error in degrees .1 to 1.5 spacings from an edge; gap: "
      "places on the true edge, projected too, to where they go (only for those who project any "
      "place; ours by the library), mean and largest. Each rival has one setting for all sets: the "
      "one with the "
      "smallest "
      "mean rms near edges, chosen with the truth; last, its best for each set, chosen the same "
      "way. RIMLS (sharpness 0.75), APSS and bilateral (25 degrees) get normals by CGAL's PCA and "
      "spanning tree with k = 16 + 64 noise neighbors. Edge-aware upsampling makes new points: its "
      "rms is of all of them, its gap from the true edge to the nearest one.");
  const std::vector<Smoother> programs = smoothers();
  std::vector<Cell> cells;
  for (const auto& [shape, sampling] :
       {std::pair{"cylinder-hole", Sampling::blue}, std::pair{"l-prism", Sampling::blue},
        std::pair{"box", Sampling::random}})
    for (const double noise : {0.0, 0.25, 0.5})
      cells.push_back(measure(places, programs, cloud_of(shape, sampling, noise), noise, board));
  const std::vector<Contender> all = contenders(cells, programs);
  board.add(contest_of(all, "rms near edges", &Quality::near));
  board.add(contest_of(all, "rms of all points", &Quality::rms));
  board.add(contest_of(all, "normal near edges [deg]", &Quality::normal));
  std::vector<std::vector<std::string>> rows;
  for (std::size_t at = 0; at < cells.size(); ++at)
    for (const Contender& c : all) rows.push_back(row_of(cells[at], c, at));
  report.table({"shape", "noise", "program", "setting", "rms", "rms near edges", "normal [deg]",
                "gap: mean", "largest", "its best near edges"},
               rows);
}

}  // namespace spigolo::bench
