// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/mesh.cpp - spigolo mesh: a sharp triangle mesh
#include "spigolo/pipeline/mesh.h"

#include <optional>
#include <utility>

#include "files.h"
#include "projection_options.h"
#include "report.h"
#include "run.h"
#include "spigolo/core/error.h"
#include "spigolo/io/shaded_mesh.h"
#include "spigolo/mesh/quality.h"
#include "spigolo/mesh/shading.h"
#include "verbs.h"

namespace spigolo {
namespace {

// Sheets, tetrahedra and labels, measured on clouds of a million points.
constexpr std::size_t bytes_per_point = 1500;

const VerbHelp help = {"mesh", "A triangle mesh whose edges run along the creases of the cloud.",
                       "spigolo mesh scan.ply -o part.stl"};

struct MeshCommand {
  CommonOptions common;
  std::string input, output;
  ProjectionChoice projection;
  MeshOptions options;
};

void declare(CommandLine& line, MeshCommand& c) {
  line.app().add_option("CLOUD", c.input, "the points; - is standard input")->required();
  line.app()
      .add_option("-o,--output", c.output, "PLY, OBJ, STL, OFF or GLB file")
      ->required()
      ->type_name("OUT");
  declare_method(line, c.projection);
  line.parameter("--sensitivity", c.options.sensitivity,
                 "of features, 0 to 1: left fewer fillets, right more obtuse edges")
      ->type_name("S");
  declare_smoothing(line, c.options.mls);
  line.parameter("--edge-length", c.options.mesher.edge_length, "of triangles, in spacings")
      ->type_name("L");
  line.parameter("--chord-error", c.options.mesher.chord_error,
                 "shorter edges where they would leave a curved surface by more, in spacings; 0: "
                 "nowhere")
      ->type_name("E");
  line.switch_parameter(
      "--close", c.options.mesher.close,
      "close wide holes too, of up to 2000 edges around, as the sheets there go on");
  declare_features(line, c.projection);
}

void check_door(MeshCommand& c) {
  const std::string ending = lower_extension(c.output);
  const std::string known = known_endings(FileUse::write_mesh) + " .glb";
  if (c.output != "-" && (ending.empty() || (known + " ").find(ending + " ") == std::string::npos))
    throw UsageError(c.output + ": the name has " +
                     (ending.empty() ? "no ending" : "the unknown ending " + ending) +
                     "; meshes go to " + known);
  check_output(c.output, c.common);
  c.options.method = c.projection.smooth_method();
}

void write_shaded(const std::string& path, const SharpMesh& sharp, bool glb, Run& run) {
  const ShadedMesh shaded{sharp.mesh, find_patches(sharp.mesh, sharp.creases), sharp.creases,
                          corner_normals(sharp.mesh, sharp.creases)};
  const Job& job = run.job();
  AtomicFile out(path);
  WriteReport report;
  glb ? write_glb(out, shaded, report) : write_shaded_obj(out, shaded, report);
  job.check();
  out.commit();
}

// PLY marks the vertices on creases; the other formats that know sharp edges get those.
void write_result(const std::string& path, const SharpMesh& sharp, Run& run) {
  const std::string ending = lower_extension(path);
  if (ending == ".glb" || ending == ".obj") {
    write_shaded(path, sharp, ending == ".glb", run);
    return;
  }
  TriangleMesh mesh = sharp.mesh;
  const FileFormat format = path == "-" ? FileFormat::ply : file_format(path, FileUse::write_mesh);
  if (format == FileFormat::ply) {
    std::vector<double> crease(mesh.vertices.size(), 0);
    for (const auto& [a, b] : sharp.creases) crease[a] = crease[b] = 1;
    mesh.vertices.set("scalar_crease", ScalarType::float32, std::move(crease));
  }
  write_surface(path, format, mesh, run);
}

// Lengths in the file's units, angles in degrees.
Json quality_json(const TriangleQuality& q) {
  return {{"smallest_angle_mean", degrees(q.angle_mean)},
          {"smallest_angle_p5", degrees(q.angle_p5)},
          {"smallest_angle_least", degrees(q.angle_least)},
          {"slim_share", q.slim},
          {"aspect_mean", q.aspect_mean},
          {"edge_mean", q.edge_mean},
          {"edge_deviation", q.edge_deviation}};
}

Json mesh_json(const MeshedCloud& meshed, const MeshCommand& c, const Json& parameters) {
  Json json = to_json(meshed.sharp.check);
  json["crease_edges"] = meshed.sharp.check.crease_edges;
  json["crease_edges_kept"] = meshed.sharp.check.crease_edges_kept;
  json["spacing"] = meshed.spacing;
  json["noise"] = meshed.noise;
  json["curves"] = meshed.network.curves.size();
  json["corners"] = meshed.network.corners.size();
  json["method"] = c.projection.method;
  json["parameters"] = parameters;
  json["duplicates"] = meshed.duplicates;
  json["non_finite"] = meshed.non_finite;
  json["outliers"] = meshed.outliers;
  json["triangle_quality"] = quality_json(measure_quality(meshed.sharp.mesh));
  json["length_share"] = meshed.sharp.length_share;
  json["holes_filled"] = meshed.sharp.holes_filled;
  json["holes_smooth"] = meshed.sharp.caps_smooth;
  json["holes_taut"] = meshed.sharp.caps_taut;
  json["holes_left"] = meshed.sharp.holes_left;
  json["holes_long"] = meshed.sharp.holes_long;
  json["handles_cut"] = meshed.sharp.handles_cut;
  json["faults_taken"] = meshed.sharp.faults_taken;
  json["parts"] = meshed.sharp.parts;
  json["uncovered"] = meshed.sharp.uncovered;
  return json;
}

Json seconds_json(const MeshedCloud& meshed, double read, double write, double total) {
  return {{"read", read},
          {"index", meshed.seconds_index},
          {"detect", meshed.seconds_detect},
          {"lines", meshed.seconds_lines},
          {"project", meshed.seconds_project},
          {"mesh", meshed.seconds_mesh},
          {"write", write},
          {"total", total}};
}

std::string mesh_text(const MeshedCloud& meshed, double seconds) {
  const MeshCheck& check = meshed.sharp.check;
  return check_text(check) + count_text(check.crease_edges_kept) + " of " +
         count_text(check.crease_edges) + " crease edges kept, " + seconds_text(seconds) + "\n";
}

}  // namespace

void run_mesh(const std::vector<std::string>& arguments) {
  MeshCommand c;
  CommandLine line(help, c.common);
  declare(line, c);
  if (!line.parse(arguments)) return;
  check_door(c);

  Run run(c.common);
  ReadReport seen;
  const PointCloud cloud = read_points(c.input, run, seen);
  warn(seen, c.input, run);
  run.check_memory(cloud.size(), bytes_per_point);
  const std::optional<Features> labels = read_labels(c.projection, cloud, run);
  if (labels) c.options.features = &*labels;
  const double read = run.lap();
  const MeshedCloud meshed = mesh_cloud(cloud.points, c.options, run.job());
  for (const std::string& warning : meshed.warnings) run.warn(warning);
  run.lap();
  write_result(c.output, meshed.sharp, run);
  const double write = run.lap();

  const Json parameters = line.parameters();
  save_parameters(c.common, help, parameters);
  Json json = mesh_json(meshed, c, parameters);
  json["seconds"] = seconds_json(meshed, read, write, run.total_seconds());
  run.print(std::move(json), mesh_text(meshed, run.total_seconds()), c.output == "-");
}

}  // namespace spigolo
