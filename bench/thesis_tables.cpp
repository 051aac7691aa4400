// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/thesis_tables.cpp - chapter 3's tables, the thesis's figures beside ours
#include <array>

#include "common.h"
#include "sections.h"

namespace spigolo::bench {
namespace {

std::string count(std::size_t n) { return std::to_string(n); }

void table_1(Report& report) {
  struct Row {
    const char* shape;
    const char* thesis;
  };
  report.heading(3, "Table 1: constructed lattices, default settings");
  report.text(
      "Detected points that lie on an edge, of those that do, and outliers (any other detected "
      "point). "
      "The thesis's sets differ a little in size; its detected number counts its outliers.");
  std::vector<std::vector<std::string>> rows;
  for (const Row& row : {Row{"cube", "575 of 580"}, Row{"planes", "257 of 256, 1 outlier"},
                         Row{"hole", "1398 of 1350, 48 outliers"}}) {
    SynthOptions options;
    options.shape = row.shape;
    const SynthCloud s = make_cloud(options);
    const Scored scored = detect_and_score(s);
    rows.push_back({row.shape, count(s.cloud.size()), row.thesis,
                    count(scored.thin.hits) + " of " + count(scored.thin.features),
                    count(scored.thin.outliers)});
  }
  report.table({"set", "points", "thesis", "found", "outliers"}, rows);
}

void table_2(Report& report) {
  struct Row {
    double percent;
    const char* thesis_count;
    const char* thesis_max;
    const char* thesis_mean;
  };
  constexpr std::array<Row, 6> thesis = {{{0.0, "839", "0", "0"},
                                          {0.4, "862", "0.25", "0.02"},
                                          {0.8, "875", "0.26", "0.03"},
                                          {1.2, "984", "0.31", "0.08"},
                                          {1.6, "1245", "0.75", "0.19"},
                                          {2.0, "1255", "0.93", "0.21"}}};
  report.heading(3, "Table 2: hole17k with noise in a ball, percent of R = 8.5");
  report.text(
      "Spacing 0.25, 838 true edge samples (thesis: 839). Sigma and the smallest cluster are the "
      "automatic ones: they follow from the noise that the program finds in the cloud, the truth "
      "is "
      "not looked at. Their three steps were chosen on this shape with another seed (77; here 1).");
  std::vector<std::vector<std::string>> rows;
  for (const Row& row : thesis) {
    SynthOptions options;
    options.shape = "hole17k";
    options.noise_percent = row.percent;
    const SynthCloud s = make_cloud(options);
    const Scored scored = detect_and_score(s);
    rows.push_back({number(row.percent, 1), row.thesis_count, count(scored.thin.flagged),
                    row.thesis_max, number(scored.deviation.max, 2), row.thesis_mean,
                    number(scored.deviation.mean, 2), number(100 * scored.thin.recall, 1),
                    count(scored.thin.outliers), number(scored.thin.f1, 3),
                    number(scored.detection.noise, 3), number(scored.detection.sigma, 1),
                    number(scored.detection.min_cluster, 2)});
  }
  report.table({"noise %", "thesis: detected", "detected", "thesis: delta_inf", "delta_inf",
                "thesis: delta_avg", "delta_avg", "recall %", "outliers", "thin F1",
                "noise found [spacings]", "sigma", "smallest cluster"},
               rows);
}

void wedges(Report& report) {
  report.heading(3, "Section 3.7.1: one edge of every angle");
  report.text(
      "Thesis: perfect above 45 degrees, a few overrated points at 45 and below, misses only near "
      "180 "
      "(k tuned by hand to 8 and 10). Here: the defaults.");
  std::vector<std::vector<std::string>> rows;
  for (const double angle : {25, 45, 60, 90, 110, 140, 160, 170}) {
    SynthOptions options;
    options.shape = "wedge";
    options.angle = radians(angle);
    const Scored scored = detect_and_score(make_cloud(options));
    double sum = 0;
    for (const double a : scored.detection.features.angle) sum += degrees(a);
    rows.push_back({number(angle), count(scored.thin.hits) + " of " + count(scored.thin.features),
                    number(100 * scored.thin.recall, 1), count(scored.thin.outliers),
                    number(180 - sum / static_cast<double>(scored.thin.flagged), 1)});
  }
  report.table({"angle [deg]", "found", "recall %", "outliers", "mean angle measured [deg]"}, rows);
}

void figure_26(Report& report) {
  report.heading(3, "Figure 26: global against local-adaptive, the nine pairs of k and sigma");
  report.text(
      "Found / outliers. The thesis shows pictures: no pair suits all of planes, and hole wants k "
      "= 10 "
      "on its outer edges and k = 20 inside. The smallest cluster is 0.15 throughout.");
  for (const char* shape : {"cube", "planes", "hole"}) {
    SynthOptions synth;
    synth.shape = shape;
    const SynthCloud s = make_cloud(synth);
    std::vector<std::vector<std::string>> rows;
    for (const std::size_t k : {10u, 16u, 20u}) {
      std::vector<std::string> row = {count(k)};
      for (const DetectMethod method : {DetectMethod::gauss_map_global, DetectMethod::gauss_map})
        for (const double sigma : {0.1, 0.5, 0.8}) {
          DetectOptions options{method, k, sigma};
          const Scored scored = detect_and_score(s, options);
          row.push_back(count(scored.thin.hits) + " / " + count(scored.thin.outliers));
        }
      rows.push_back(row);
    }
    report.text(std::string("`") + shape + "`:");
    report.table({"k", "global, sigma 0.1", "global, 0.5", "global, 0.8", "adaptive, 0.1",
                  "adaptive, 0.5", "adaptive, 0.8"},
                 rows);
  }
}

}  // namespace

void thesis_tables(Report& report) {
  report.heading(2, "The thesis's tables (chapter 3, method `gauss-map`)");
  table_1(report);
  table_2(report);
  wedges(report);
  figure_26(report);
}

}  // namespace spigolo::bench
