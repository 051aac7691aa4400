// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/lines.cpp - spigolo lines: feature curves and corners for CAD
#include "spigolo/pipeline/lines.h"

#include <utility>
#include <vector>

#include "files.h"
#include "report.h"
#include "run.h"
#include "spigolo/core/error.h"
#include "spigolo/io/curve_writers.h"
#include "spigolo/pipeline/curve_step.h"
#include "verbs.h"

namespace spigolo {
namespace {

// As for detect, and what lies along the features.
constexpr std::size_t bytes_per_point = 1100;

const VerbHelp help = {"lines",
                       "Feature curves and corners of a cloud, as lines, arcs and splines.",
                       "spigolo lines scan.ply -o edges.dxf -o edges.json --unit mm"};

struct LinesCommand {
  CommonOptions common;
  std::string input;
  std::vector<std::string> outputs;
  std::string method = "sheets", unit = "none";
  double tolerance = automatic_tolerance;
  bool require = false;
  LinesOptions options;
};

void declare(CommandLine& line, LinesCommand& c) {
  line.app().add_option("CLOUD", c.input, "the points; - is standard input")->required();
  line.app()
      .add_option("-o,--output", c.outputs,
                  "DXF, STEP, OBJ, PLY, VTP, JSON or CSV; repeat it for more")
      ->required()
      ->take_all()
      ->expected(1)
      ->type_name("OUT");
  line.parameter("--method", c.method, "sheets or gauss-map (thesis, local-adaptive)")
      ->check(CLI::IsMember({"sheets", "gauss-map"}))
      ->type_name("NAME");
  line.parameter("--sensitivity", c.options.detect.sensitivity,
                 "of sheets, 0 to 1: left fewer fillets, right more obtuse edges")
      ->type_name("S");
  line.parameter("--tolerance", c.tolerance, "between splines and curves, in units of the cloud")
      ->default_str("auto")
      ->transform([](const std::string& text) {
        return text == "auto" ? std::to_string(automatic_tolerance) : text;
      })
      ->type_name("D");
  line.parameter("--unit", c.unit, "what one unit of the cloud is: none, mm, cm, m, in, ft")
      ->type_name("U");
  line.switch_parameter("--require", c.require, "no feature at all is an error: exit status 4");
}

bool is_step(const std::string& output) {
  const std::string ending = lower_extension(output);
  return ending == ".step" || ending == ".stp";
}

void check_door(LinesCommand& c) {
  for (const std::string& output : c.outputs) {
    if (output != "-" && !is_step(output)) curve_format(output);
    if (is_step(output)) check_step_unit(length_unit(c.unit));
    check_output(output, c.common);
  }
  length_unit(c.unit);
  if (c.tolerance != automatic_tolerance && !(c.tolerance > 0))
    throw UsageError("--tolerance must be above 0");
  c.options.tolerance = c.tolerance;
  c.options.detect.method = c.method == "sheets" ? DetectMethod::sheets : DetectMethod::gauss_map;
}

// All of them appear, or none.
void write_all(const LinesCommand& c, const Lines& lines, const Job& job) {
  const CurveFileOptions options{length_unit(c.unit), lines.detection.spacing};
  std::vector<AtomicFile> files;
  for (const std::string& output : c.outputs) {
    files.emplace_back(output);
    if (is_step(output)) {
      files.back().write(step_text(lines.network, options.unit));
      continue;
    }
    const CurveFormat format = output == "-" ? CurveFormat::ply : curve_format(output);
    write_curves(files.back(), format, lines.network, options);
  }
  job.check();
  commit_all(files);
}

struct Counts {
  std::size_t curves = 0, borders = 0, closed = 0, bridged = 0;
  std::array<std::size_t, curve_shape_names.size()> shape{};
  double length = 0;
};

Counts count(const FeatureCurves& network) {
  Counts n;
  for (const FeatureCurve& curve : network.curves) {
    if (curve.kind == CurveKind::border) {
      ++n.borders;
      continue;
    }
    ++n.curves;
    n.closed += curve.closed;
    n.bridged += curve.bridged;
    ++n.shape[static_cast<std::size_t>(curve.shape)];
    n.length += curve.length();
  }
  return n;
}

Json lines_json(const LinesCommand& c, const Lines& lines, const Json& parameters,
                const DetectTimes& times) {
  const Counts n = count(lines.network);
  Json json = detect_json(lines.detection, c.method, parameters, times);
  json["counts"] = {{"curves", n.curves},
                    {"corners", lines.network.corners.size()},
                    {"borders", n.borders},
                    {"closed", n.closed},
                    {"bridged", n.bridged},
                    {"lines", n.shape[static_cast<std::size_t>(CurveShape::line)]},
                    {"circles", n.shape[static_cast<std::size_t>(CurveShape::circle)]},
                    {"arcs", n.shape[static_cast<std::size_t>(CurveShape::arc)]},
                    {"splines", n.shape[static_cast<std::size_t>(CurveShape::spline)]}};
  json["length"] = n.length;
  json["tolerance"] = lines.tolerance;
  json["unit"] = c.unit;
  json["outputs"] = c.outputs;
  json["seconds"]["trace"] = lines.seconds_trace;
  return json;
}

std::string lines_text(const Lines& lines, const DetectTimes& times) {
  const Counts n = count(lines.network);
  std::string text = count_text(n.curves) + " curves (";
  bool first = true;
  for (const CurveShape shape :
       {CurveShape::line, CurveShape::circle, CurveShape::arc, CurveShape::spline}) {
    const auto s = static_cast<std::size_t>(shape);
    if (n.shape[s] == 0) continue;
    text += (first ? "" : ", ") + std::string(curve_shape_names[s]) + " " + count_text(n.shape[s]);
    first = false;
  }
  text += (first ? "none)" : ")") + std::string(", ") + count_text(lines.network.corners.size()) +
          " corners, " + count_text(n.borders) + " borders, length " + number_text(n.length);
  return text + "\n" + seconds_text(times.total) + "\n";
}

}  // namespace

void run_lines(const std::vector<std::string>& arguments) {
  LinesCommand c;
  CommandLine line(help, c.common);
  declare(line, c);
  if (!line.parse(arguments)) return;
  check_door(c);

  Run run(c.common);
  DetectTimes times;
  ReadReport seen;
  const PointCloud cloud = read_points(c.input, run, seen);
  warn(seen, c.input, run);
  run.check_memory(cloud.size(), bytes_per_point);
  times.read = run.lap();
  const Lines lines = find_lines(cloud.points, c.options, run.job());
  for (const std::string& warning : lines.detection.warnings) run.warn(warning);
  if (lines.network.curves.empty()) {
    if (c.require) throw NoResultError(c.input + ": there is no feature curve in this cloud");
    run.warn("there is no feature curve in this cloud; what is written is empty");
  }
  run.lap();
  write_all(c, lines, run.job());
  times.write = run.lap();
  times.total = run.total_seconds();

  const Json parameters = line.parameters();
  save_parameters(c.common, help, parameters);
  bool to_stdout = false;
  for (const std::string& output : c.outputs) to_stdout |= output == "-";
  run.print(lines_json(c, lines, parameters, times), lines_text(lines, times), to_stdout);
}

}  // namespace spigolo
