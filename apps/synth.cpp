// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/synth.cpp - spigolo synth: a constructed shape with the exact truth
#include "spigolo/synth/synth.h"

#include <algorithm>
#include <array>

#include "files.h"
#include "report.h"
#include "run.h"
#include "spigolo/core/error.h"
#include "suggest.h"
#include "verbs.h"

namespace spigolo {
namespace {

// The shape's points with exact distances to all its creases, while they are made.
constexpr std::size_t bytes_per_point = 200;

const VerbHelp help = {"synth",
                       "Sample a constructed shape; the file carries the truth: truth_feature, "
                       "truth_edge_distance, truth_kind.",
                       "spigolo synth wedge --angle 120 --points 20000 --noise 0.05 -o wedge.ply"};

constexpr std::array<const char*, 6> samplings = {"auto", "lattice", "random",
                                                  "blue", "scan",    "view"};

struct SynthCommand {
  CommonOptions common;
  std::string shape, output, sampling = samplings[0];
  double angle = 90;  // degrees
  bool list = false;
  SynthOptions options;
};

void declare(CommandLine& line, SynthCommand& c) {
  CLI::App& app = line.app();
  app.add_option("SHAPE", c.shape, "its name; --list shows all");
  app.add_option("-o,--output", c.output, "the cloud; - is PLY on standard output")
      ->type_name("OUT");
  app.add_flag("--list", c.list, "list the shapes and exit");
  line.parameter(
          "--sampling", c.sampling,
          "auto (lattice if there is one, else blue), lattice, random, blue, scan (lines four "
          "times denser along than across), view (what scanners at --views places see)")
      ->check(CLI::IsMember({"auto", "lattice", "random", "blue", "scan", "view"}))
      ->type_name("HOW");
  line.parameter("--points", c.options.points, "how many; 0: the shape's own number")
      ->type_name("N");
  line.parameter(
          "--noise", c.options.noise,
          "standard deviation along each axis, in h, the median distance to the nearest point")
      ->type_name("X");
  line.parameter("--noise-percent", c.options.noise_percent,
                 "radius of uniform noise, in percent of the bounding sphere's")
      ->type_name("X");
  line.parameter("--angle", c.angle, "of wedge, fade and spike, 5 to 175 degrees")
      ->type_name("DEG");
  line.parameter("--size,--radius", c.options.size,
                 "fillet radius, chamfer width or thickness, in spacings")
      ->type_name("X");
  line.parameter("--sides", c.options.sides, "of the pyramid, 3 to 12")->type_name("N");
}

void declare_hardships(CommandLine& line, SynthCommand& c) {
  line.parameter("--views", c.options.views, "scanner places of --sampling view, 1 to 64")
      ->type_name("N");
  line.parameter("--density-gradient", c.options.density_gradient,
                 "random and blue: so many times denser at one end of the longest side")
      ->type_name("X");
  line.parameter("--noise-gradient", c.options.noise_gradient,
                 "so many times more noise at one end of the second longest side")
      ->type_name("X");
  line.parameter("--duplicates", c.options.duplicates, "share of samples that come twice")
      ->type_name("X");
  line.parameter("--outliers", c.options.outliers, "share of points added anywhere around")
      ->type_name("X");
}

std::vector<std::string> shape_names() {
  std::vector<std::string> names;
  for (const ShapeInfo& shape : synth_shapes()) names.emplace_back(shape.name);
  return names;
}

void check_door(SynthCommand& c) {
  if (c.shape.empty()) throw UsageError("no shape named; 'spigolo synth --list' shows them");
  const auto names = shape_names();
  if (std::find(names.begin(), names.end(), c.shape) == names.end())
    throw UsageError("there is no shape '" + c.shape + "'" + suggestion(c.shape, names) +
                     "; 'spigolo synth --list' shows them");
  if (c.output.empty()) throw UsageError("-o OUT is required: where to write the cloud");
  check_output(c.output, c.common);
  const auto how = std::find(samplings.begin(), samplings.end(), c.sampling);
  c.options.sampling = static_cast<Sampling>(how - samplings.begin());
  c.options.shape = c.shape;
  c.options.angle = radians(c.angle);
  c.options.seed = c.common.seed;
}

void print_shapes(Run& run) {
  Json json = Json::object();
  std::string text;
  for (const ShapeInfo& shape : synth_shapes()) {
    json["shapes"].push_back(
        {{"name", shape.name}, {"help", shape.help}, {"lattice", shape.lattice}});
    std::string name = shape.name;
    name.resize(std::max<std::size_t>(name.size() + 1, 14), ' ');
    text += name + shape.help + (shape.lattice ? " (lattice)" : "") + "\n";
  }
  run.print(json, text);
}

std::size_t count_features(const PointCloud& cloud) {
  const Attribute* truth = cloud.find("truth_feature");
  return truth == nullptr ? 0
                          : static_cast<std::size_t>(
                                std::count(truth->values.begin(), truth->values.end(), 1.0));
}

}  // namespace

void run_synth(const std::vector<std::string>& arguments) {
  SynthCommand c;
  CommandLine line(help, c.common);
  declare(line, c);
  declare_hardships(line, c);
  if (!line.parse(arguments)) return;
  Run run(c.common);
  if (c.list) return print_shapes(run);
  check_door(c);

  const FileFormat format = output_format(c.output, FileFormat::ply);
  run.check_memory(c.options.points, bytes_per_point);
  const SynthCloud made = make_cloud(c.options, run.job());
  const double seconds_make = run.lap();
  write_surface(c.output, format, {made.cloud, {}}, run);
  save_parameters(c.common, help, line.parameters());

  const std::size_t features = count_features(made.cloud);
  const Json json = {
      {"shape", c.shape},
      {"points", made.cloud.size()},
      {"features", features},
      {"spacing", made.spacing},
      {"lattice", made.lattice},
      {"parameters", line.parameters()},
      {"seconds", {{"make", seconds_make}, {"write", run.lap()}, {"total", run.total_seconds()}}}};
  run.print(json,
            c.shape + ": " + count_text(made.cloud.size()) + " points, " + count_text(features) +
                " on sharp features, spacing " + number_text(made.spacing) + "\n",
            c.output == "-");
}

}  // namespace spigolo
