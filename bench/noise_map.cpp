// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/noise_map.cpp - one edge of every angle under every noise, beside what anyone could reach
#include "common.h"
#include "heat_map.h"
#include "on_all_cores.h"
#include "sections.h"

namespace spigolo::bench {
namespace {

constexpr double angles[] = {60, 70, 80, 90, 100, 110, 120, 130, 140, 150, 160, 170};
constexpr double noises[] = {0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.75, 1};
constexpr std::uint64_t seeds[] = {21, 22};
constexpr double usable = 0.9, half = 0.5, none = 0.05;  // F1 that the limits are read off

/// Best tolerant F1 of any mark by the exact distance of the noisy samples to the true edge.
double ceiling(const SynthCloud& s) {
  const FeatureTruth truth = read_truth(s.cloud, s.spacing, s.lattice);
  std::vector<double> distances;
  for (const Vec3& p : s.cloud.points) distances.push_back(edge_distance(s.shape, p));
  double best = 0;
  for (double limit = 0.4; limit < 2.5; limit += 0.1) {
    std::vector<std::uint8_t> flags;
    for (const double d : distances) flags.push_back(d <= limit * s.spacing);
    best = std::max(best, classify(flags, truth, Scoring::tolerant).f1);
  }
  return best;
}

struct Cell {
  double f1 = 0, recall = 0, ceiling = 0;
  bool warned = false;
};

struct Place {
  double angle = 0, noise = 0;
};

Cell measure(const Place& place) {
  const auto& [angle, noise] = place;
  Cell cell;
  for (const std::uint64_t seed : seeds) {
    SynthOptions options{.shape = "wedge", .sampling = Sampling::blue, .points = 5000};
    options.angle = radians(angle), options.noise = noise, options.seed = seed;
    const SynthCloud s = make_cloud(options);
    const Scored scored = detect_and_score(s);
    cell.f1 += scored.tolerant.f1 / std::size(seeds);
    cell.recall += scored.tolerant.recall / std::size(seeds);
    cell.ceiling += ceiling(s) / std::size(seeds);
    cell.warned = cell.warned || !scored.detection.warnings.empty();
  }
  return cell;
}

using Row = std::vector<Cell>;  // one noise, all angles

/// The widest angle up to which (from 60 degrees on) F1 is at least `least`.
std::string widest(const Row& row, double least) {
  std::string angle = "-";
  for (std::size_t a = 0; a < row.size() && row[a].f1 >= least; ++a) angle = number(angles[a]);
  return angle;
}

/// The first angle from which on nothing is found.
std::string blind_from(const Row& row) {
  std::size_t a = row.size();
  while (a > 0 && row[a - 1].recall < none) --a;
  return a == row.size() ? "-" : number(angles[a]);
}

std::vector<std::string> cells_of(std::size_t n, const Row& row) {
  std::vector<std::string> cells = {number(noises[n], 2)};
  bool warned = false;
  double ceilings = 0;
  for (const Cell& cell : row) {
    cells.push_back(number(cell.f1, 2));
    warned = warned || cell.warned;
    ceilings += cell.ceiling / static_cast<double>(row.size());
  }
  for (const double least : {usable, half}) cells.push_back(widest(row, least));
  cells.insert(cells.end(), {blind_from(row), number(ceilings, 3), warned ? "yes" : "no"});
  return cells;
}

HeatMap panel(const std::string& title, const std::vector<Row>& rows, double Cell::*value) {
  HeatMap map{title, "interior angle [deg]", "noise [h]", {}, {}, {}};
  for (const double angle : angles) map.columns.push_back(number(angle));
  for (std::size_t n = 0; n < rows.size(); ++n) {
    map.rows.push_back(number(noises[n], 2));
    map.value.emplace_back();
    for (const Cell& cell : rows[n]) map.value.back().push_back(cell.*value);
  }
  return map;
}

}  // namespace

void noise_map(Report& report, const std::filesystem::path& pictures) {
  std::vector<Place> places;
  for (const double noise : noises)
    for (const double angle : angles) places.push_back({angle, noise});
  const std::vector<Cell> cells = on_all_cores(places, measure);
  std::vector<Row> rows;
  for (auto from = cells.begin(); from != cells.end(); from += std::ssize(angles))
    rows.emplace_back(from, from + std::ssize(angles));
  report.heading(2, "Angle against noise");
  report.text(
      "Tolerant F1 of `sheets` on `wedge`, blue samples, mean of two seeds (21, 22). Noise is the "
      "standard deviation per axis in h. Beside it: the widest angle up to which F1 is at least .9 "
      "and .5, the angle from which on less than 5 % is found (nothing can be told), the ceiling: "
      "the best F1 of marking by the exact distance of the noisy samples to the true edge, with "
      "the "
      "best limit, mean over the angles; and whether the program warned.");
  report.text("![Tolerant F1 by angle and noise, and its ceiling](pictures/noise-map.png)");
  std::vector<std::string> head = {"noise"};
  for (const double angle : angles) head.push_back(number(angle) + " deg");
  head.insert(head.end(), {".9 up to", ".5 up to", "nothing from", "ceiling", "warned"});
  std::vector<std::vector<std::string>> table;
  for (std::size_t n = 0; n < rows.size(); ++n) table.push_back(cells_of(n, rows[n]));
  report.table(head, table);
  write_heat_maps(pictures / "noise-map.png",
                  {panel("sheets: tolerant F1", rows, &Cell::f1),
                   panel("ceiling: exact distance of the noisy samples", rows, &Cell::ceiling)});
}

}  // namespace spigolo::bench
