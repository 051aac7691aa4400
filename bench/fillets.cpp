// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/fillets.cpp - from which radius on a rounded edge is no edge, and what the dial does
#include "common.h"
#include "line_chart.h"
#include "on_all_cores.h"
#include "sections.h"

namespace spigolo::bench {
namespace {

constexpr double sensitivities[] = {0.25, 0.5, 0.75};

DetectOptions with(double sensitivity) {
  DetectOptions options;
  options.sensitivity = sensitivity;
  return options;
}

struct Fillet {
  double radius;  // [mean spacings]
  Sampling sampling;
  double noise;
};

using Values = std::vector<double>;  // one a sensitivity

/// False marks in 1000 points.
Values false_marks(const Fillet& fillet) {
  SynthOptions options{.shape = "fillet-box", .sampling = fillet.sampling, .points = 10000};
  options.size = fillet.radius, options.noise = fillet.noise, options.seed = 23;
  const SynthCloud s = make_cloud(options);
  Values values;
  for (const double sensitivity : sensitivities) {
    const auto flagged = static_cast<double>(detect_and_score(s, with(sensitivity)).thin.flagged);
    values.push_back(1000 * flagged / static_cast<double>(s.cloud.size()));
  }
  return values;
}

struct Edge {
  double angle, noise;
};

/// Tolerant F1.
Values found(const Edge& edge) {
  SynthOptions options{.shape = "wedge", .sampling = Sampling::blue, .points = 6000};
  options.angle = radians(edge.angle), options.noise = edge.noise, options.seed = 23;
  const SynthCloud s = make_cloud(options);
  Values values;
  for (const double sensitivity : sensitivities)
    values.push_back(detect_and_score(s, with(sensitivity)).tolerant.f1);
  return values;
}

std::vector<std::string> row_of(std::vector<std::string> head, const Values& values, int digits) {
  for (const double value : values) head.push_back(number(value, digits));
  return head;
}

/// values: of each x in turn.
LineChart chart(const std::string& title, const std::string& across, const std::string& up,
                const std::vector<double>& x, const std::vector<Values>& values) {
  LineChart result{title, across, up, x, {}};
  for (std::size_t c = 0; c < std::size(sensitivities); ++c) {
    Values curve;
    for (const Values& at : values) curve.push_back(at[c]);
    result.curves.emplace_back("sensitivity " + number(sensitivities[c], 2), std::move(curve));
  }
  return result;
}

const std::vector<double> radii = {1, 1.5, 2, 3, 4, 5, 6, 8};
const std::vector<double> angles = {120, 135, 150, 165};
constexpr double fillet_noises[] = {0, 0.25}, edge_noises[] = {0, 0.1, 0.25};

std::string noise_text(double noise) {
  return noise > 0 ? ", noise " + number(noise, 2) + " h" : ", no noise";
}

void tabulate_fillets(Report& report, std::vector<LineChart>& charts) {
  std::vector<Fillet> fillets;
  for (const double noise : fillet_noises)
    for (const Sampling sampling : {Sampling::random, Sampling::blue})
      for (const double radius : radii) fillets.push_back({radius, sampling, noise});
  const std::vector<Values> values = on_all_cores(fillets, false_marks);
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < fillets.size(); ++i)
    rows.push_back(row_of(
        {number(fillets[i].radius, 1), fillets[i].sampling == Sampling::blue ? "blue" : "random",
         number(fillets[i].noise, 2)},
        values[i], 2));
  report.table({"radius", "samples", "noise", "sensitivity .25", ".5", ".75"}, rows);
  for (std::size_t n = 0; n < std::size(fillet_noises); ++n) {
    const auto from = values.begin() + std::ssize(radii) * static_cast<std::ptrdiff_t>(2 * n + 1);
    LineChart c = chart("rounded box, blue" + noise_text(fillet_noises[n]), "radius [spacings]",
                        "false marks in 1000 points", radii, {from, from + std::ssize(radii)});
    c.low = 0.1, c.high = 1000, c.decades = true;
    charts.push_back(std::move(c));
  }
}

void tabulate_edges(Report& report, std::vector<LineChart>& charts) {
  std::vector<Edge> edges;
  for (const double noise : edge_noises)
    for (const double angle : angles) edges.push_back({angle, noise});
  const std::vector<Values> values = on_all_cores(edges, found);
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < edges.size(); ++i)
    rows.push_back(row_of({number(edges[i].angle), number(edges[i].noise, 2)}, values[i], 3));
  report.table({"edge [deg]", "noise", "sensitivity .25", ".5", ".75"}, rows);
  for (std::size_t n = 0; n < std::size(edge_noises); n += 2) {
    const auto from = values.begin() + std::ssize(angles) * static_cast<std::ptrdiff_t>(n);
    LineChart c = chart("single edge, blue" + noise_text(edge_noises[n]), "interior angle [deg]",
                        "tolerant F1", angles, {from, from + std::ssize(angles)});
    c.legend_below = true;
    charts.push_back(std::move(c));
  }
}

}  // namespace

void fillets(Report& report, const std::filesystem::path& pictures) {
  report.heading(2, "Fillets against obtuse edges: the one dial");
  report.text(
      "`fillet-box` has no edge: every mark is false. Radius in mean spacings, false marks in 1000 "
      "points for three sensitivities (0.5 is the default). Under it what the same dial does to "
      "true obtuse edges: tolerant F1 on `wedge`. Seed 23. In the picture 0.1 means 0.1 or less.");
  report.text("![False marks by radius, found edges by angle](pictures/fillets.png)");
  std::vector<LineChart> charts;
  tabulate_fillets(report, charts);
  tabulate_edges(report, charts);
  write_line_charts(pictures / "fillets.png", charts);
}

}  // namespace spigolo::bench
