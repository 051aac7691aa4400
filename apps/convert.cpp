// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/convert.cpp - spigolo convert: read one format, write another
#include "files.h"
#include "report.h"
#include "run.h"
#include "spigolo/core/error.h"
#include "verbs.h"

namespace spigolo {
namespace {

const VerbHelp help = {"convert",
                       "Read a cloud or mesh and write it in another format. Faces are kept where "
                       "both formats have them, attributes where the new one has a place.",
                       "spigolo convert scan.las -o scan.ply"};

struct ConvertCommand {
  CommonOptions common;
  std::string input, output, stdout_format = "xyz";
  bool ascii = false, compressed = false;
};

void declare(CommandLine& line, ConvertCommand& c) {
  CLI::App& app = line.app();
  app.add_option("IN", c.input, "the file to read; - is standard input")->required();
  app.add_option("-o,--output", c.output, "the file to write, format by its ending; - is stdout")
      ->required()
      ->type_name("OUT");
  line.parameter("--format", c.stdout_format, "of standard output: xyz or ply")
      ->check(CLI::IsMember({"xyz", "ply"}))
      ->type_name("NAME");
  line.switch_parameter("--ascii", c.ascii, "text instead of binary: ply, pcd, stl");
  line.switch_parameter("--compressed", c.compressed, "compressed binary: pcd");
}

}  // namespace

void run_convert(const std::vector<std::string>& arguments) {
  ConvertCommand c;
  CommandLine line(help, c.common);
  declare(line, c);
  if (!line.parse(arguments)) return;
  const bool ply = c.stdout_format == "ply";
  const FileFormat format = output_format(c.output, ply ? FileFormat::ply : FileFormat::xyz);
  check_output(c.output, c.common);

  Run run(c.common);
  ReadReport seen;
  const TriangleMesh mesh = read_surface(c.input, run, seen);
  warn(seen, c.input, run);
  const double seconds_read = run.lap();
  write_surface(c.output, format, mesh, run, {c.ascii, c.compressed, seen.grid, {}});
  save_parameters(c.common, help, line.parameters());

  const Json json = {
      {"input", c.input},
      {"output", c.output},
      {"points", mesh.vertices.size()},
      {"triangles", mesh.triangles.size()},
      {"attributes", attributes_json(mesh.vertices)},
      {"seconds", {{"read", seconds_read}, {"write", run.lap()}, {"total", run.total_seconds()}}}};
  const std::string faces =
      mesh.triangles.empty() ? "" : ", " + count_text(mesh.triangles.size()) + " triangles";
  run.print(json, c.output + ": " + count_text(mesh.vertices.size()) + " points" + faces + "\n",
            c.output == "-");
}

}  // namespace spigolo
