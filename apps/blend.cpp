// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/blend.cpp - spigolo blend: a scan and a CAD face made one cloud
#include "spigolo/pipeline/blend.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <utility>
#include <vector>

#include "blend_report.h"
#include "cad_reader.h"
#include "cad_report.h"
#include "feature_cloud.h"
#include "files.h"
#include "report.h"
#include "run.h"
#include "spigolo/cad/step_writer.h"
#include "spigolo/core/error.h"
#include "spigolo/io/atomic_file.h"
#include "spigolo/pipeline/mesh.h"
#include "verbs.h"

namespace spigolo {
namespace {

// Index, neighbors, normals and the result; thinning holds some hundred bytes a new point.
constexpr std::size_t bytes_per_point = 1200;

// Cloud, face, collar.
constexpr std::array<std::array<double, 3>, 3> source_colors = {
    {{214, 217, 222}, {150, 180, 214}, {240, 165, 80}}};

const VerbHelp help = {
    "blend", "Blend a cloud with a NURBS face of a STEP or IGES file by a smooth collar.",
    "spigolo blend scan.ply tube.step --start v1 -o blended.ply\n"
    "spigolo blend scan.ply part.step --face 3 --start v=0.5+ --start v=0.5- \\\n"
    "  --radius 4 -o blended.ply -o collar.step"};

struct BlendCommand {
  CommonOptions common;
  std::string cloud, cad;
  std::vector<std::string> outputs;
  std::string mesh;
  int face = -1;
  std::vector<std::string> starts;
  std::string keep, method = "tangent";
  double radius = not_a_number, height = not_a_number, width = not_a_number;
  bool sharp = false;
  BlendOptions options;
};

CLI::Option* length(CLI::Option* option) { return option->default_str("auto")->type_name("R"); }

void declare(CommandLine& line, BlendCommand& c) {
  line.app().add_option("CLOUD", c.cloud, "the points; - is standard input")->required();
  line.app().add_option("CAD", c.cad, "STEP or IGES file")->required();
  line.app()
      .add_option("-o,--output", c.outputs, "PLY file of the result; also a .step of the collar")
      ->required()
      ->type_name("OUT.ply");
  line.parameter("--face", c.face, "number of the face, as info lists them; default: the only one")
      ->type_name("N")
      ->check(CLI::NonNegativeNumber)
      ->default_str("");
  line.parameter("--start", c.starts,
                 "where to begin: u0 u1 v0 v1 (a border) or like v=0.4+ (an isoline and the way to "
                 "go); several allowed; default: the border outside the cloud")
      ->type_name("SPEC")
      ->allow_extra_args(false)
      ->default_str("");
  length(line.parameter("--radius", c.radius, "of the ball that rounds the collar, in spacings"));
  length(line.parameter("--height", c.height, "of the collar along the face, in spacings"));
  length(line.parameter("--width", c.width, "of the collar along the cloud, in spacings"));
  line.parameter("--keep", c.keep, "side of the cloud that stays: +x -x +y -y +z -z or DX,DY,DZ")
      ->type_name("DIR");
  line.parameter("--method", c.method, "tangent, or linear (the thesis's collar)")
      ->check(CLI::IsMember({"tangent", "linear"}))
      ->type_name("NAME");
  line.switch_parameter("--sharp", c.sharp, "detect sharp edges of the result and keep them");
  line.app()
      .add_option("--mesh", c.mesh, "also a mesh of the result: .ply .obj .stl .off")
      ->type_name("OUT2");
}

// "-x" is a direction here, no option.
std::vector<std::string> joined_directions(const std::vector<std::string>& arguments) {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const bool direction = arguments[i] == "--keep" && i + 1 < arguments.size();
    out.push_back(direction ? "--keep=" + arguments[i + 1] : arguments[i]);
    if (direction) ++i;
  }
  return out;
}

Vec3 parse_direction(const std::string& text) {
  const auto bad = [&] {
    throw UsageError("--keep '" + text + "' is none of +x -x +y -y +z -z and not like 0.5,0,-1");
  };
  if (text.size() == 2 && (text[0] == '+' || text[0] == '-') && text[1] >= 'x' && text[1] <= 'z') {
    Vec3 direction;
    direction[static_cast<std::size_t>(text[1] - 'x')] = text[0] == '+' ? 1 : -1;
    return direction;
  }
  Vec3 direction;
  const char* at = text.c_str();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    char* end = nullptr;
    direction[axis] = std::strtod(at, &end);
    if (end == at || *end != (axis < 2 ? ',' : '\0')) bad();
    at = end + 1;
  }
  return direction;
}

// Given but not positive is an error; not given is 0, chosen by the library.
double positive(double value, const char* name) {
  if (std::isnan(value)) return 0;
  if (!(value > 0)) throw UsageError(std::string(name) + " must be above 0");
  return value;
}

bool is_step(const std::string& path) {
  return lower_extension(path) == ".step" || lower_extension(path) == ".stp";
}

void check_outputs(const BlendCommand& c) {
  std::size_t clouds = 0;
  for (const std::string& output : c.outputs) {
    const bool ply = output == "-" || lower_extension(output) == ".ply";
    if (!ply && !is_step(output))
      throw UsageError("blend writes the cloud as .ply and the collar as .step; " + output +
                       " is neither");
    clouds += ply;
    check_output(output, c.common);
  }
  if (clouds != 1) throw UsageError("name one .ply output, and a .step for the collar if wanted");
  if (c.outputs.size() > 2) throw UsageError("name one .ply and one .step output at most");
  if (c.outputs.size() > 1 && c.method == "linear")
    throw UsageError(
        "the collar of the method 'linear' is no surface; only 'tangent' writes .step");
}

void check_door(BlendCommand& c) {
  check_outputs(c);
  if (!c.mesh.empty()) {
    file_format(c.mesh, FileUse::write_mesh);
    check_output(c.mesh, c.common);
  }
  c.options.method = c.method == "linear" ? BlendMethod::linear : BlendMethod::tangent;
  for (const std::string& start : c.starts) c.options.starts.push_back(parse_start(start));
  c.options.radius = positive(c.radius, "--radius");
  c.options.height = positive(c.height, "--height");
  c.options.width = positive(c.width, "--width");
  if (!c.keep.empty()) c.options.keep = parse_direction(c.keep);
  c.options.seed = c.common.seed;
  check_options(c.options);
}

NurbsFace choose_face(const BlendCommand& c, const CadFile& file) {
  const std::size_t count = file.faces().size();
  if (count == 0) throw NoResultError(c.cad + " holds no face");
  if (c.face < 0 && count > 1) {
    std::string list = face_lines(file);
    list.pop_back();
    throw NoResultError(c.cad + " holds several faces; say with --face which one:\n" + list);
  }
  return file.face(c.face < 0 ? 0 : static_cast<std::size_t>(c.face));
}

PointCloud cloud_of(const Blend& blend) {
  PointCloud cloud;
  cloud.points = blend.points;
  std::vector<double> values(blend.points.size());
  const auto add = [&](const char* name, const auto& value) {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = value(i);
    cloud.set(name, ScalarType::float32, values);
  };
  add("nx", [&](std::size_t i) { return blend.normals[i].x; });
  add("ny", [&](std::size_t i) { return blend.normals[i].y; });
  add("nz", [&](std::size_t i) { return blend.normals[i].z; });
  add("scalar_source", [&](std::size_t i) { return static_cast<double>(blend.source[i]); });
  const std::array<const char*, 3> channels = {"red", "green", "blue"};
  for (std::size_t channel = 0; channel < channels.size(); ++channel) {
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = source_colors[static_cast<std::size_t>(blend.source[i])][channel];
    cloud.set(channels[channel], ScalarType::uint8, values);
  }
  return cloud;
}

// All of them appear, or none.
void write_outputs(const BlendCommand& c, const CadFile& cad, const SharpBlend& result,
                   const std::optional<MeshedCloud>& meshed, Run& run) {
  PointCloud cloud = cloud_of(result.blend);
  if (c.sharp) cloud = with_features(std::move(cloud), result.features);
  run.job();  // an interrupt waits until the temporary files are gone
  std::vector<AtomicFile> files;
  for (const std::string& output : c.outputs)
    if (is_step(output)) {
      StepContent content;
      content.name = "collar";
      for (const NurbsSurface& collar : result.blend.collars) content.faces.push_back({collar, {}});
      files.emplace_back(output).write(step_text(content, cad.unit().empty() ? "mm" : cad.unit()));
    }
  const auto ply = std::find_if_not(c.outputs.begin(), c.outputs.end(), is_step);
  files.push_back(staged_surface(*ply, FileFormat::ply, {std::move(cloud), {}}, run));
  if (meshed)
    files.push_back(
        staged_surface(c.mesh, file_format(c.mesh, FileUse::write_mesh), meshed->sharp.mesh, run));
  run.job().check();
  commit_all(files);
}

// The collar is never a crease; edges of the cloud are.
MeshedCloud mesh_blend(const std::vector<Vec3>& cloud, const BlendCommand& c, SharpBlend& result,
                       Run& run) {
  if (!c.sharp) result.features = label_blend(cloud, result.blend, run.job());
  MeshOptions options;
  options.features = &result.features;
  MeshedCloud meshed = mesh_cloud(result.blend.points, options, run.job());
  for (const std::string& warning : meshed.warnings) run.warn(warning);
  return meshed;
}

Json parameters_used(const CommandLine& line, const BlendCommand& c) {
  Json json = line.parameters();
  for (const char* name : {"radius", "height", "width"})
    if (!json[name].is_number() || std::isnan(json[name].get<double>())) json.erase(name);
  if (c.face < 0) json.erase("face");
  if (c.keep.empty()) json.erase("keep");
  return json;
}

}  // namespace

void run_blend(const std::vector<std::string>& arguments) {
  BlendCommand c;
  CommandLine line(help, c.common);
  declare(line, c);
  if (!line.parse(joined_directions(arguments))) return;
  check_door(c);

  Run run(c.common);
  run.check_file_size(c.cad);
  const CadFile cad = read_cad(c.cad, c.common);
  const NurbsFace face = choose_face(c, cad);
  ReadReport seen;
  const PointCloud cloud = read_points(c.cloud, run, seen);
  warn(seen, c.cloud, run);
  run.check_memory(cloud.size(), bytes_per_point);
  const double seconds_read = run.lap();
  SharpBlend result;
  if (c.sharp)
    result = blend_sharp(cloud.points, face, c.options, run.job());
  else
    result.blend = blend(cloud.points, face, c.options, run.job());
  for (const std::string& warning : result.blend.warnings) run.warn(warning);
  const double seconds_blend = run.lap();
  std::optional<MeshedCloud> meshed;
  if (!c.mesh.empty()) meshed = mesh_blend(cloud.points, c, result, run);
  const double seconds_mesh = run.lap();
  write_outputs(c, cad, result, meshed, run);

  const Json parameters = parameters_used(line, c);
  save_parameters(c.common, help, parameters);
  Json json = blend_json(result.blend, c.method, parameters);
  json["seconds"] = {{"read", seconds_read},
                     {"blend", seconds_blend},
                     {"mesh", seconds_mesh},
                     {"write", run.lap()},
                     {"total", run.total_seconds()}};
  if (meshed) json["mesh"] = to_json(meshed->sharp.check);
  run.print(json, blend_text(result.blend, c.method, run.total_seconds()),
            c.outputs.front() == "-");
}

}  // namespace spigolo
