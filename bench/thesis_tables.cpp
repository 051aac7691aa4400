// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/thesis_tables.cpp - chapter 3's tables, the thesis's figures beside ours
#include <array>

#include "common.h"
#include "on_all_cores.h"
#include "sections.h"

namespace spigolo::bench {
namespace {

std::string count(std::size_t n) { return std::to_string(n); }

std::string found(const Scored& scored) {
  return count(scored.thin.hits) + " of " + count(scored.thin.features) + ", " +
         count(scored.thin.outliers) + " outliers";
}

void table_1(Report& report) {
  struct Row {
    const char* shape;
    const char* thesis;
  };
  report.heading(3, "Table 1: constructed lattices, default settings");
  report.text(
      "Detected points that lie on an edge, of those that do, and outliers (any other detected "
      "point). "
      "The thesis's sets differ a little in size; its detected number counts its outliers. The "
      "smallest cluster, 0.15, "
      "was chosen on these sets and the wedges below.");
  const std::vector<Row> sets = {Row{"cube", "575 of 580"}, Row{"planes", "257 of 256, 1 outlier"},
                                 Row{"hole", "1398 of 1350, 48 outliers"}};
  const auto row_of = [](const Row& row) -> std::vector<std::string> {
    SynthOptions options{.shape = row.shape};
    const SynthCloud s = make_cloud(options);
    const Scored ours = detect_and_score(s, thesis_method()), sheets = detect_and_score(s);
    return {row.shape, count(s.cloud.size()), row.thesis, found(ours), found(sheets)};
  };
  report.table({"set", "points", "thesis", "`gauss-map`", "`sheets`"}, on_all_cores(sets, row_of));
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
      "Spacing 0.25, 838 true edge samples (thesis: 839). `gauss-map`: sigma and the smallest "
      "cluster are the automatic ones, which follow from the noise that the program finds in the "
      "cloud; the truth is not looked at. Their three steps were chosen on this shape with another "
      "seed (77; here 1), the constants of `sheets` were looked at with seed 5.");
  const auto row_of = [](const Row& row) -> std::vector<std::string> {
    SynthOptions options{.shape = "hole17k", .noise_percent = row.percent};
    const SynthCloud s = make_cloud(options);
    const Scored ours = detect_and_score(s, thesis_method()), sheets = detect_and_score(s);
    return {number(row.percent, 1),
            row.thesis_count,
            row.thesis_max,
            row.thesis_mean,
            count(ours.thin.flagged),
            number(ours.deviation.max, 2),
            number(ours.deviation.mean, 2),
            number(100 * ours.thin.recall, 1),
            number(ours.thin.f1, 3),
            count(sheets.thin.flagged),
            number(sheets.deviation.max, 2),
            number(sheets.deviation.mean, 2),
            number(100 * sheets.thin.recall, 1),
            number(sheets.thin.f1, 3),
            number(ours.detection.noise, 3)};
  };
  report.table({"noise %", "thesis: detected", "delta_inf", "delta_avg", "`gauss-map`: detected",
                "delta_inf", "delta_avg", "recall %", "thin F1", "`sheets`: detected", "delta_inf",
                "delta_avg", "recall %", "thin F1", "noise found [spacings]"},
               on_all_cores(thesis, row_of));
}

void smallest_clusters(Report& report) {
  report.heading(3, "The smallest cluster, which the text leaves open");
  report.text(
      "Found / outliers of `gauss-map` by the share of the triangles that a cluster must have; the "
      "default without noise is 0.15.");
  std::vector<SynthCloud> clouds;
  for (const char* shape : {"planes", "hole", "hole17k"}) {
    SynthOptions synth{.shape = shape};
    clouds.push_back(make_cloud(synth));
  }
  const auto row_of = [&clouds](double share) {
    DetectOptions options = thesis_method();
    options.min_cluster = share;
    std::vector<std::string> row = {number(share, 2)};
    for (const SynthCloud& cloud : clouds) {
      const Scored scored = detect_and_score(cloud, options);
      row.push_back(count(scored.thin.hits) + " / " + count(scored.thin.outliers));
    }
    return row;
  };
  report.table({"share", "`planes` (256)", "`hole` (1350)", "`hole17k` (838)"},
               on_all_cores(std::vector<double>{0.05, 0.1, 0.12, 0.15}, row_of));
}

void wedges(Report& report) {
  report.heading(3, "Section 3.7.1: one edge of every angle");
  report.text(
      "Thesis: perfect above 45 degrees, a few overrated points at 45 and below, misses only near "
      "180 "
      "(k tuned by hand to 8 and 10). Here: the defaults.");
  const auto row_of = [](double angle) {
    SynthOptions options{.shape = "wedge", .angle = radians(angle)};
    const SynthCloud cloud = make_cloud(options);
    std::vector<std::string> row = {number(angle)};
    for (const DetectOptions& method : {thesis_method(), DetectOptions{}}) {
      const Scored scored = detect_and_score(cloud, method);
      double sum = 0;
      for (const double a : scored.detection.features.angle) sum += degrees(a);
      row.push_back(found(scored));
      row.push_back(number(180 - sum / static_cast<double>(scored.thin.flagged), 1));
    }
    return row;
  };
  report.table(
      {"angle [deg]", "`gauss-map`", "its mean angle [deg]", "`sheets`", "its mean angle [deg]"},
      on_all_cores(std::vector<double>{25, 45, 60, 90, 110, 140, 160, 170}, row_of));
}

void figure_26(Report& report) {
  report.heading(3, "Figure 26: global against local-adaptive, the nine pairs of k and sigma");
  report.text(
      "Found / outliers. The thesis shows pictures: no pair suits all of planes, and hole wants k "
      "= 10 "
      "on its outer edges and k = 20 inside. The smallest cluster is 0.15 throughout.");
  for (const char* shape : {"cube", "planes", "hole"}) {
    SynthOptions synth{.shape = shape};
    const SynthCloud s = make_cloud(synth);
    const auto row_of = [&s](std::size_t k) {
      std::vector<std::string> row = {count(k)};
      for (const DetectMethod method : {DetectMethod::gauss_map_global, DetectMethod::gauss_map})
        for (const double sigma : {0.1, 0.5, 0.8}) {
          DetectOptions options;
          options.method = method;
          options.k = k;
          options.sigma = sigma;
          options.min_cluster = 0.15;
          const Scored scored = detect_and_score(s, options);
          row.push_back(count(scored.thin.hits) + " / " + count(scored.thin.outliers));
        }
      return row;
    };
    report.text(std::string("`") + shape + "`:");
    report.table({"k", "global, sigma 0.1", "global, 0.5", "global, 0.8", "adaptive, 0.1",
                  "adaptive, 0.5", "adaptive, 0.8"},
                 on_all_cores(std::vector<std::size_t>{10, 16, 20}, row_of));
  }
}

void figures_21_and_22(Report& report) {
  report.heading(3, "Figures 21 and 22: the global method's k and sigma");
  report.text(
      "Found / outliers of `gauss-map-global`. Figure 21 shows k = 8, 16 and 32 on the trim star, "
      "whose edges are not known; here `hole`, sigma 0.6. Figure 22 shows sigma = 0.05, 0.1, 0.6 "
      "and 1 on `planes`, here with k = 16. The thesis: small values overrate acute angles, 1 "
      "misses obtuse ones. Here the smallest cluster, 0.15, keeps small values clean.");
  struct Case {
    const char* figure;
    const char* shape;
    std::size_t k;
    double sigma;
  };
  const auto row_of = [](const Case& c) -> std::vector<std::string> {
    SynthOptions synth{.shape = c.shape};
    DetectOptions options;
    options.method = DetectMethod::gauss_map_global;
    options.k = c.k, options.sigma = c.sigma, options.min_cluster = 0.15;
    const Scored scored = detect_and_score(make_cloud(synth), options);
    return {c.figure,
            c.shape,
            count(c.k),
            number(c.sigma, 2),
            count(scored.thin.features),
            count(scored.thin.hits) + " / " + count(scored.thin.outliers)};
  };
  report.table({"figure", "set", "k", "sigma", "feature points", "found / outliers"},
               on_all_cores(std::vector<Case>{{"21", "hole", 8, 0.6},
                                              {"21", "hole", 16, 0.6},
                                              {"21", "hole", 32, 0.6},
                                              {"22", "planes", 16, 0.05},
                                              {"22", "planes", 16, 0.1},
                                              {"22", "planes", 16, 0.6},
                                              {"22", "planes", 16, 1.0}},
                            row_of));
}

}  // namespace

void thesis_tables(Report& report) {
  report.heading(2, "The thesis's tables (chapter 3)");
  table_1(report);
  table_2(report);
  smallest_clusters(report);
  figures_21_and_22(report);
  wedges(report);
  figure_26(report);
}

}  // namespace spigolo::bench
