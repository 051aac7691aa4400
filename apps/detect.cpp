// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/detect.cpp - spigolo detect: a label for every point
#include "spigolo/detect/detect.h"

#include <utility>

#include "feature_cloud.h"
#include "files.h"
#include "report.h"
#include "run.h"
#include "spigolo/core/error.h"
#include "spigolo/pipeline/lines.h"
#include "verbs.h"

namespace spigolo {
namespace {

// Measured on clouds of some million points; ordering, index and verdicts together.
// Noise makes it look at 96 neighbors a point: that is the most.
constexpr std::size_t bytes_per_point = 1000;

const VerbHelp help = {"detect", "Label every point of a cloud: surface, edge, corner or border.",
                       "spigolo detect scan.ply -o features.ply"};

struct DetectCommand {
  CommonOptions common;
  std::string input, output;
  std::string method = "sheets";
  DetectOptions options;
};

// "auto" stands for from_noise.
CLI::Option* by_noise(CLI::Option* option) {
  return option->default_str("auto")->transform(
      [](const std::string& text) { return text == "auto" ? std::to_string(from_noise) : text; });
}

void declare(CommandLine& line, DetectCommand& c) {
  line.app().add_option("CLOUD", c.input, "the points; - is standard input")->required();
  line.app()
      .add_option("-o,--output", c.output, "PLY file with the labels; - is standard output")
      ->required()
      ->type_name("OUT.ply");
  line.parameter("--method", c.method,
                 "sheets, gauss-map (thesis, local-adaptive) or gauss-map-global")
      ->check(CLI::IsMember({"sheets", "gauss-map", "gauss-map-global"}))
      ->type_name("NAME");
  line.parameter("--sensitivity", c.options.sensitivity,
                 "of sheets, 0 to 1: left fewer fillets, right more obtuse edges")
      ->type_name("S");
  line.parameter("--k", c.options.k, "neighbors of a point, 4 to 64")->type_name("N");
  by_noise(line.parameter("--sigma", c.options.sigma,
                          "merge clusters closer than this; larger finds less"))
      ->type_name("RAD");
  line.parameter("--flatness", c.options.flatness, "normals that spread less are flat, 0 to 1")
      ->type_name("SHARE");
  by_noise(line.parameter("--min-cluster", c.options.min_cluster,
                          "smaller clusters are noise, 0 to 0.5"))
      ->type_name("SHARE");
}

void check_door(DetectCommand& c) {
  if (c.output != "-" && lower_extension(c.output) != ".ply")
    throw UsageError("detect writes PLY: name the output " + c.output +
                     ".ply, and 'spigolo convert' it to another format");
  check_output(c.output, c.common);
  c.options.method = c.method == "sheets"      ? DetectMethod::sheets
                     : c.method == "gauss-map" ? DetectMethod::gauss_map
                                               : DetectMethod::gauss_map_global;
}

// What was chosen by the noise stands there as if it had been given.
Json parameters_used(const CommandLine& line, const Detection& detection) {
  Json json = line.parameters();
  const bool sheets = json["method"] == "sheets";
  if (sheets) {
    for (const char* idle : {"k", "sigma", "flatness", "min_cluster"}) json.erase(idle);
  } else {
    json.erase("sensitivity");
    json["sigma"] = detection.sigma;
    json["min_cluster"] = detection.min_cluster;
  }
  return json;
}

// An option that the chosen method never looks at was a misunderstanding.
void warn_of_idle_options(CommandLine& line, const DetectCommand& c, Run& run) {
  const bool sheets = c.options.method == DetectMethod::sheets;
  const std::vector<std::string> idle =
      sheets ? std::vector<std::string>{"--k", "--sigma", "--flatness", "--min-cluster"}
             : std::vector<std::string>{"--sensitivity"};
  for (const std::string& option : idle)
    if (line.app().count(option) > 0) run.warn(option + " has no effect with --method " + c.method);
}

}  // namespace

void run_detect(const std::vector<std::string>& arguments) {
  DetectCommand c;
  CommandLine line(help, c.common);
  declare(line, c);
  if (!line.parse(arguments)) return;
  check_door(c);

  Run run(c.common);
  warn_of_idle_options(line, c, run);
  DetectTimes times;
  ReadReport seen;
  PointCloud cloud = read_points(c.input, run, seen);
  warn(seen, c.input, run);
  run.check_memory(cloud.size(), bytes_per_point);
  times.read = run.lap();
  const Lines lines = find_lines(cloud.points, {c.options}, run.job());  // numbers the curves too
  const Detection& detection = lines.detection;
  for (const std::string& warning : detection.warnings) run.warn(warning);
  run.lap();
  write_surface(c.output, FileFormat::ply,
                {with_features(std::move(cloud), detection.features), {}}, run);
  times.write = run.lap();
  times.total = run.total_seconds();

  const Json parameters = parameters_used(line, detection);
  save_parameters(c.common, help, parameters);
  run.print(detect_json(detection, c.method, parameters, times),
            detect_text(detection, c.method, times), c.output == "-");
}

}  // namespace spigolo
