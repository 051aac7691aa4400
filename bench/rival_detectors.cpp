// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/rival_detectors.cpp
#include "rival_detectors.h"

#include <iterator>
#include <sstream>

#include "common.h"
#include "meter.h"
#include "plain_search.h"

namespace spigolo::bench {
namespace {

bool run_vcm(const RivalPlaces& places, const std::string& in, const fs::path& out,
             double spacing) {
  return run_rival(places, {places.program("cgal_vcm"), in, out.string(), number(spacing, 12)});
}
bool run_pca(const RivalPlaces& places, const std::string& in, const fs::path& out, double) {
  return run_rival(places, {places.program("multi_scale_pca"), in, out.string()});
}
bool run_pcl(const RivalPlaces& places, const std::string& in, const fs::path& out, double) {
  return run_rival(places, {places.program("pcl_curvature"), in, out.string()});
}
bool run_cloudcompare(const RivalPlaces& places, const std::string& in, const fs::path& out,
                      double spacing) {
  std::vector<std::string> command = {"env",
                                      "QT_QPA_PLATFORM=offscreen",
                                      "CloudCompare",
                                      "-SILENT",
                                      "-NO_TIMESTAMP",
                                      "-AUTO_SAVE",
                                      "OFF",
                                      "-O",
                                      in,
                                      "-C_EXPORT_FMT",
                                      "ASC",
                                      "-PREC",
                                      "12",
                                      "-ADD_HEADER"};
  for (const double radius : {1.5, 2.0, 3.0, 4.0})
    command.insert(command.end(), {"-FEATURE", "SURFACE_VARIATION", number(radius * spacing, 12)});
  command.emplace_back("-SAVE_CLOUDS");
  const fs::path made = fs::path(in).replace_extension(".asc");
  fs::remove(made);
  if (!run_rival(places, command) || !fs::exists(made)) return false;
  fs::rename(made, out);
  return true;
}

std::vector<std::string> words_of(const char* text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::string>(in), {}};
}

}  // namespace

const std::array<Detector, detector_count> detectors = {
    {{"CGAL VCM", run_vcm, "15", 0},
     {"multi-scale PCA", run_pca, "7", 0},
     {"PCL curvature", run_pcl, "6", 0},
     {"CloudCompare surface variation", run_cloudcompare, "4", 3,
      "radius-1.5 radius-2 radius-3 radius-4"}}};

void ask_all(const RivalPlaces& places, Set& set) {
  const fs::path in = places.file("detect.xyz"), out = places.file("scores.txt");
  write_xyz(in, set.points);
  for (std::size_t r = 0; r < detectors.size(); ++r) {
    fs::remove(out);
    const double start = children_seconds();
    if (!detectors[r].run(places, in.string(), out, set.spacing)) continue;
    auto scores = read_scores(out, detectors[r].skip);
    if (!scores || scores->columns.empty() || scores->columns[0].size() != set.points.size())
      continue;
    if (detectors[r].names != nullptr) scores->names = words_of(detectors[r].names);
    set.scores[r] = std::move(*scores);
    set.seconds[r] = children_seconds() - start;
  }
  const double start = cpu_seconds();
  set.sheets = sharp_flags(detect(set.points).features);
  set.sheets_seconds = cpu_seconds() - start;
  set.thesis = sharp_flags(detect(set.points, thesis_method()).features);
  set.thesis_seconds = cpu_seconds() - start - set.sheets_seconds;
}

void note_costs(const Set& set, Scoreboard& board) {
  const std::size_t n = set.points.size();
  const double search = search_seconds(set.points, 16);
  board.add_cost("`detect` (`sheets`)", "1", set.sheets_seconds, n, search);
  board.add_cost("`detect --method gauss-map`", "1", set.thesis_seconds, n, search);
  for (std::size_t r = 0; r < detectors.size(); ++r)
    if (set.seconds[r] > 0)
      board.add_cost(detectors[r].name, detectors[r].settings, set.seconds[r], n, search);
}

}  // namespace spigolo::bench
