// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/fillets.cpp - from which radius on a rounded edge is no edge, and what the dial does
#include "common.h"
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

std::vector<std::string> fillet_row(const Fillet& fillet) {
  const auto& [radius, sampling, noise] = fillet;
  SynthOptions options{.shape = "fillet-box", .sampling = sampling, .points = 10000};
  options.size = radius, options.noise = noise, options.seed = 23;
  const SynthCloud s = make_cloud(options);
  std::vector<std::string> row = {number(radius, 1), sampling == Sampling::blue ? "blue" : "random",
                                  number(noise, 2)};
  for (const double sensitivity : sensitivities) {
    const auto flagged = static_cast<double>(detect_and_score(s, with(sensitivity)).thin.flagged);
    row.push_back(number(1000 * flagged / static_cast<double>(s.cloud.size()), 2));
  }
  return row;
}

struct Edge {
  double angle, noise;
};

std::vector<std::string> edge_row(const Edge& edge) {
  const auto& [angle, noise] = edge;
  SynthOptions options{.shape = "wedge", .sampling = Sampling::blue, .points = 6000};
  options.angle = radians(angle), options.noise = noise, options.seed = 23;
  const SynthCloud s = make_cloud(options);
  std::vector<std::string> row = {number(angle), number(noise, 2)};
  for (const double sensitivity : sensitivities)
    row.push_back(number(detect_and_score(s, with(sensitivity)).tolerant.f1, 3));
  return row;
}

}  // namespace

void fillets(Report& report) {
  report.heading(2, "Fillets against obtuse edges: the one dial");
  report.text(
      "`fillet-box` has no edge: every mark is false. Radius in mean spacings, false marks in 1000 "
      "points for three sensitivities (0.5 is the default). Under it what the same dial does to "
      "true obtuse edges: tolerant F1 on `wedge`. Seed 23.");
  std::vector<Fillet> fillets;
  for (const double noise : {0.0, 0.25})
    for (const Sampling sampling : {Sampling::random, Sampling::blue})
      for (const double radius : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0})
        fillets.push_back({radius, sampling, noise});
  report.table({"radius", "samples", "noise", "sensitivity .25", ".5", ".75"},
               on_all_cores(fillets, fillet_row));
  std::vector<Edge> edges;
  for (const double noise : {0.0, 0.1, 0.25})
    for (const double angle : {120.0, 135.0, 150.0, 165.0}) edges.push_back({angle, noise});
  report.table({"edge [deg]", "noise", "sensitivity .25", ".5", ".75"},
               on_all_cores(edges, edge_row));
}

}  // namespace spigolo::bench
