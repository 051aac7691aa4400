// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/compare.cpp - spigolo compare: distances of A to B and of B to A
#include <cmath>
#include <optional>
#include <utility>

#include "files.h"
#include "report.h"
#include "run.h"
#include "spigolo/core/error.h"
#include "spigolo/measure/distance.h"
#include "spigolo/measure/samples.h"
#include "spigolo/render/palette.h"
#include "verbs.h"

namespace spigolo {
namespace {

constexpr std::size_t bytes_per_point = 400;
// Long faces and lines are measured from about so many places, whatever their number.
constexpr double places_on_a_mesh = 100000, places_on_lines = 20000;

const VerbHelp help = {
    "compare",
    "Distances of A to B and of B to A; each a cloud, a mesh with faces, or lines ('lines' writes "
    "them). To meshes and lines they are exact; to a mesh they have a sign: positive outside.",
    "spigolo compare scan.ply part.stl --tolerance 0.1 --require 0.95 -o "
    "deviation.ply"};

struct CompareCommand {
  CommonOptions common;
  std::string a, b, output;
  double tolerance = 0;  // [unit of the input] 0: not asked for
  double require = 0;    // share; 0: not asked for
};

void declare(CommandLine& line, CompareCommand& c) {
  line.app().add_option("A", c.a, "cloud, mesh or lines; - is standard input")->required();
  line.app().add_option("B", c.b, "cloud, mesh or lines")->required();
  line.app()
      .add_option("-o,--output", c.output, "A coloured by its distance to B, scalar_deviation")
      ->type_name("OUT.ply");
  line.parameter("--tolerance", c.tolerance, "report the share of A no farther than this from B")
      ->type_name("D");
  line.parameter("--require", c.require, "fail with status 4 if that share is smaller, 0 to 1")
      ->type_name("SHARE");
}

void check_door(const CompareCommand& c) {
  if (!(c.tolerance >= 0 && std::isfinite(c.tolerance)))
    throw UsageError("--tolerance must be a distance above 0, in the unit of the files");
  if (!(c.require >= 0 && c.require <= 1)) throw UsageError("--require must be between 0 and 1");
  if (c.require > 0 && c.tolerance == 0)
    throw UsageError("--require is a share of points within --tolerance; give that too");
  if (c.output.empty()) return;
  if (c.output != "-" && lower_extension(c.output) != ".ply")
    throw UsageError("compare writes PLY: name the output " + c.output + ".ply");
  check_output(c.output, c.common);
}

// One of the two inputs, with the places distances are measured from: its vertices, then places
// between them where faces or lines are long.
struct Side {
  TriangleMesh mesh;
  Segments segments;
  std::vector<Vec3> places;

  bool is_mesh() const { return !mesh.triangles.empty(); }
  bool is_lines() const { return !is_mesh() && !segments.empty(); }
  const std::vector<Vec3>& vertices() const { return mesh.vertices.points; }
};

void add_places_between(Side& side) {
  side.places = side.vertices();
  std::vector<Vec3> more;
  if (side.is_mesh())
    more = places_between(side.mesh, std::sqrt(area_of(side.mesh) / places_on_a_mesh));
  else if (side.is_lines())
    more = places_between(side.vertices(), side.segments,
                          length_of(side.vertices(), side.segments) / places_on_lines);
  side.places.insert(side.places.end(), more.begin(), more.end());
}

Side read_side(const std::string& path, Run& run) {
  ReadReport seen;
  Side side;
  FileLines lines;
  side.mesh = read_surface(path, run, seen, &lines);
  side.segments = pieces_of(lines);
  warn(seen, path, run);
  add_places_between(side);
  return side;
}

std::vector<double> distances(const Side& from, const Side& to, const Job& job) {
  if (to.is_mesh()) return distances_to_mesh(from.places, to.mesh, true, job);
  if (to.is_lines()) return distances_to_segments(from.places, to.vertices(), to.segments, job);
  return distances_to_points(from.places, to.vertices(), job);
}

// What -o writes: A itself; of lines, the places that were measured.
TriangleMesh surface_of(Side&& side) {
  if (side.is_lines()) return {PointCloud{std::move(side.places), {}}, {}};
  return std::move(side.mesh);
}

// Colours run to the 95th percentile, so that a few strays do not pale the rest. Labels that A came
// with are left out: 'render' would draw them instead.
TriangleMesh with_deviation(TriangleMesh a, std::vector<double> deviation, bool with_sign) {
  deviation.resize(a.vertices.size());  // places between vertices have no vertex to colour
  const double range = summarize(deviation).p95;
  std::vector<double> red(deviation.size()), green(deviation.size()), blue(deviation.size());
  for (std::size_t i = 0; i < deviation.size(); ++i) {
    const double t = range > 0 ? deviation[i] / range : deviation[i] * 0;
    const Color color = with_sign ? map_color(ColorMap::diverging, 0.5 + 0.5 * t)
                                  : map_color(ColorMap::sequential, t);
    red[i] = color.r, green[i] = color.g, blue[i] = color.b;
  }
  a.vertices.set("red", ScalarType::uint8, std::move(red));
  a.vertices.set("green", ScalarType::uint8, std::move(green));
  a.vertices.set("blue", ScalarType::uint8, std::move(blue));
  a.vertices.set("scalar_deviation", ScalarType::float32, std::move(deviation));
  std::erase_if(a.vertices.attributes,
                [](const Attribute& attribute) { return attribute.name == "scalar_kind"; });
  return a;
}

std::string stats_text(const char* title, const DistanceStats& s, bool with_sign) {
  return std::string(title) + "  mean " + number_text(s.mean) + ", rms " + number_text(s.rms) +
         ", p95 " + number_text(s.p95) + ", max " + number_text(s.max) +
         (with_sign ? ", signed mean " + number_text(s.signed_mean) : "") + "\n";
}

// Everything that was measured.
struct Measured {
  std::vector<double> a_to_b, b_to_a;
  double spacing = 0;  // of A
};

Measured measure(const Side& a, const Side& b, const Job& job) {
  return {distances(a, b, job), distances(b, a, job), summarize(a.vertices(), job).spacing};
}

Json compare_json(const CompareCommand& c, const Measured& m) {
  Json json = {{"a_to_b", to_json(summarize(m.a_to_b))},
               {"b_to_a", to_json(summarize(m.b_to_a))},
               {"spacing", m.spacing}};
  if (c.tolerance > 0) {
    json["tolerance"] = c.tolerance;
    json["inside"] = share_within(m.a_to_b, c.tolerance);
    json["inside_b_to_a"] = share_within(m.b_to_a, c.tolerance);
  }
  if (c.require > 0) json["required"] = c.require;
  return json;
}

std::string compare_text(const CompareCommand& c, const Measured& m, bool a_mesh, bool b_mesh) {
  std::string text = stats_text("A to B", summarize(m.a_to_b), b_mesh) +
                     stats_text("B to A", summarize(m.b_to_a), a_mesh) + "spacing of A  " +
                     number_text(m.spacing) + "\n";
  if (c.tolerance > 0)
    text += "within " + number_text(c.tolerance) + "  " +
            number_text(100 * share_within(m.a_to_b, c.tolerance)) + " % of A\n";
  return text;
}

}  // namespace

void run_compare(const std::vector<std::string>& arguments) {
  CompareCommand c;
  CommandLine line(help, c.common);
  declare(line, c);
  if (!line.parse(arguments)) return;
  check_door(c);

  Run run(c.common);
  Side a = read_side(c.a, run);
  const Side b = read_side(c.b, run);
  const bool a_mesh = a.is_mesh(), b_mesh = b.is_mesh();
  run.check_memory(a.places.size() + b.places.size(), bytes_per_point);
  const Measured m = measure(a, b, run.job());
  const bool met = c.require == 0 || share_within(m.a_to_b, c.tolerance) >= c.require;
  if (met && !c.output.empty())
    write_surface(c.output, FileFormat::ply,
                  with_deviation(surface_of(std::move(a)), m.a_to_b, b_mesh), run);
  if (met) save_parameters(c.common, help, line.parameters());

  Json json = compare_json(c, m);
  json["seconds"] = {{"total", run.total_seconds()}};
  run.print(json, compare_text(c, m, a_mesh, b_mesh), c.output == "-");
  if (!met)
    throw NoResultError("only " + number_text(100 * share_within(m.a_to_b, c.tolerance)) +
                        " % of A lie within " + number_text(c.tolerance) + " of B, less than the " +
                        number_text(100 * c.require) + " % required; nothing is written");
}

}  // namespace spigolo
