// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/smooth.cpp - spigolo smooth: every point projected onto the sharp surface
#include "spigolo/pipeline/smooth.h"

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "files.h"
#include "projection_options.h"
#include "report.h"
#include "run.h"
#include "spigolo/core/error.h"
#include "spigolo/measure/distance.h"
#include "verbs.h"

namespace spigolo {
namespace {

// Index, neighbors, labels and results together, measured on clouds of a million points.
constexpr std::size_t bytes_per_point = 1200;
constexpr const char* status_names[] = {"sheet", "crease", "corner"};

const VerbHelp help = {
    "smooth", "Project every point onto the surface of the cloud, keeping its edges sharp.",
    "spigolo smooth scan.ply -o smooth.ply"};

struct SmoothCommand {
  CommonOptions common;
  std::string input, output;
  ProjectionChoice projection;
  SmoothOptions options;
};

void declare(CommandLine& line, SmoothCommand& c) {
  line.app().add_option("CLOUD", c.input, "the points; - is standard input")->required();
  line.app()
      .add_option("-o,--output", c.output, "PLY file; - is standard output")
      ->required()
      ->type_name("OUT.ply");
  declare_method(line, c.projection);
  declare_smoothing(line, c.options.mls);
  declare_features(line, c.projection);
}

void check_door(SmoothCommand& c) {
  if (c.output != "-" && lower_extension(c.output) != ".ply")
    throw UsageError("smooth writes PLY: name the output " + c.output +
                     ".ply, and 'spigolo convert' it to another format");
  check_output(c.output, c.common);
  c.options.method = c.projection.smooth_method();
}

PointCloud with_surface(PointCloud cloud, const Smoothed& s) {
  std::vector<Attribute> carried = std::exchange(cloud.attributes, {});
  cloud.points = s.position;
  const auto add = [&](const char* name, const auto& value) {
    std::vector<double> values(s.size());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = value(i);
    cloud.set(name, ScalarType::float32, std::move(values));
  };
  add("nx", [&](std::size_t i) { return s.normal[i].x; });
  add("ny", [&](std::size_t i) { return s.normal[i].y; });
  add("nz", [&](std::size_t i) { return s.normal[i].z; });
  add("scalar_deviation", [&](std::size_t i) { return s.deviation[i]; });
  add("scalar_curvature1", [&](std::size_t i) { return s.curvature[i][0]; });
  add("scalar_curvature2", [&](std::size_t i) { return s.curvature[i][1]; });
  add("scalar_kind", [&](std::size_t i) { return static_cast<double>(s.kind[i]); });
  add("scalar_status", [&](std::size_t i) { return static_cast<double>(s.status[i]); });
  for (Attribute& attribute : carried)
    if (!cloud.find(attribute.name)) cloud.attributes.push_back(std::move(attribute));
  return cloud;
}

Json parameters_used(const CommandLine& line, const Smoothed& s) {
  Json json = line.parameters();
  json["k"] = s.mls.k;
  json["smoothing"] = s.mls.smoothing;
  return json;
}

std::array<std::size_t, 4> status_counts(const Smoothed& s) {
  std::array<std::size_t, 4> counts{};
  for (const SurfaceStatus status : s.status)
    ++counts[on_surface(status) ? static_cast<std::size_t>(status) : 3];
  return counts;
}

Json smooth_json(const Smoothed& s, const std::string& method, const Json& parameters) {
  Json counts;
  const auto of_status = status_counts(s);
  for (std::size_t i = 0; i < 3; ++i) counts[status_names[i]] = of_status[i];
  counts["none"] = of_status[3];
  return {{"points", s.size()},
          {"spacing", s.spacing},
          {"noise", s.noise},
          {"counts", counts},
          {"deviation", to_json(summarize(s.deviation))},
          {"method", method},
          {"parameters", parameters},
          {"k_used", s.mls.k},
          {"duplicates", s.duplicates},
          {"non_finite", s.non_finite}};
}

std::string smooth_text(const Smoothed& s, const std::string& method, double seconds) {
  const DistanceStats moved = summarize(s.deviation);
  const auto counts = status_counts(s);
  std::string text = count_text(s.size()) + " points, spacing " + number_text(s.spacing) +
                     ", noise " + number_text(s.noise) + " spacings\n" + "moved by rms " +
                     number_text(moved.rms) + ", at most " + number_text(moved.max) + "; " +
                     count_text(counts[1] + counts[2]) + " onto edges and corners";
  if (counts[3] > 0) text += ", " + count_text(counts[3]) + " not";
  return text + "\n" + method + ", k " + std::to_string(s.mls.k) + ", smoothing " +
         number_text(s.mls.smoothing) + " spacings, " + seconds_text(seconds) + "\n";
}

}  // namespace

void run_smooth(const std::vector<std::string>& arguments) {
  SmoothCommand c;
  CommandLine line(help, c.common);
  declare(line, c);
  if (!line.parse(arguments)) return;
  check_door(c);

  Run run(c.common);
  ReadReport seen;
  PointCloud cloud = read_points(c.input, run, seen);
  warn(seen, c.input, run);
  run.check_memory(cloud.size(), bytes_per_point);
  const std::optional<Features> labels = read_labels(c.projection, cloud, run);
  if (labels) c.options.features = &*labels;
  const double seconds_read = run.lap();
  const Smoothed smoothed = smooth(cloud.points, c.options, run.job());
  for (const std::string& warning : smoothed.warnings) run.warn(warning);
  run.lap();
  write_surface(c.output, FileFormat::ply, {with_surface(std::move(cloud), smoothed), {}}, run);

  const Json parameters = parameters_used(line, smoothed);
  save_parameters(c.common, help, line.parameters());
  Json json = smooth_json(smoothed, c.projection.method, parameters);
  json["seconds"] = {{"read", seconds_read},
                     {"index", smoothed.seconds_index},
                     {"detect", smoothed.seconds_detect},
                     {"project", smoothed.seconds_project},
                     {"write", run.lap()},
                     {"total", run.total_seconds()}};
  run.print(json, smooth_text(smoothed, c.projection.method, run.total_seconds()), c.output == "-");
}

}  // namespace spigolo
