// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/guarantees.cpp - README.md's exit statuses, tried on the program, and what a run that fails
// does to an older file in its output's place
#include <fstream>
#include <iterator>

#include "sections.h"
#include "spigolo/io/cloud_file.h"
#include "spigolo/synth/synth.h"

namespace spigolo::bench {
namespace {

constexpr const char* older = "an older file";

struct Trial {
  std::string what;
  int status;
  std::string shell;  // $S: the program, $O: its output; run by bash in the scratch folder
};

std::vector<Trial> trials() {
  return {{"a labelled cloud", 0, "$S detect cloud.ply -o $O"},
          {"an unknown option", 2, "$S detect cloud.ply -o $O --sharp"},
          {"an output in a folder that is not there", 2, "$S detect cloud.ply -o nowhere/$O"},
          {"an input that is not there", 3, "$S detect missing.ply -o $O"},
          {"an input cut off", 3, "$S detect cut.ply -o $O"},
          {"three points", 4, "$S detect three.xyz -o $O"},
          {"`--require` without a feature", 4, "$S lines sphere.ply -o $O --require"},
          {"over `--memory`", 5, "$S mesh cloud.ply -o $O --memory 1M"},
          {"Ctrl-C after a tenth of a second", 130,
           "timeout --preserve-status -s INT 0.1 $S mesh cloud.ply -o $O"},
          {"a reader of its pipe that closes early", 141,
           "$S convert cloud.ply -o - | head -c 1 >/dev/null; exit ${PIPESTATUS[0]}"}};
}

std::string content_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_inputs(const RivalPlaces& places) {
  fs::create_directories(places.scratch);
  write_cloud(places.file("cloud.ply"), make_cloud({.shape = "hole"}).cloud);
  write_cloud(places.file("sphere.ply"), make_cloud({.shape = "sphere"}).cloud);
  std::ofstream(places.file("cut.ply")) << content_of(places.file("cloud.ply")).substr(0, 5000);
  std::ofstream(places.file("three.xyz")) << "0 0 0\n1 0 0\n0 1 0\n";
}

std::vector<std::string> row_of(const RivalPlaces& places, const Trial& trial) {
  const fs::path output = places.file("output.ply");
  std::ofstream(output) << older;
  const std::string settings = "cd '" + fs::absolute(places.scratch).string() + "' && S='" +
                               fs::absolute(places.spigolo).string() + "' O=output.ply; ";
  const int status = run_status(places, {"bash", "-c", settings + trial.shell});
  const bool kept = content_of(output) == older;
  return {trial.what, std::to_string(trial.status),
          status == trial.status ? std::to_string(status) : "**" + std::to_string(status) + "**",
          kept ? "as it was" : "replaced"};
}

}  // namespace

void guarantees(Report& report, const RivalPlaces& places) {
  report.heading(3, "Exit statuses, and an older file in the output's place");
  write_inputs(places);
  std::vector<std::vector<std::string>> rows;
  for (const Trial& trial : trials()) rows.push_back(row_of(places, trial));
  report.table({"run", "exit status, promised", "found", "older file"}, rows);
}

}  // namespace spigolo::bench
