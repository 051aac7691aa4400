// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/info.cpp - spigolo info: what a file holds
#include "cad_reader.h"
#include "cad_report.h"
#include "files.h"
#include "report.h"
#include "run.h"
#include "spigolo/index/summary.h"
#include "verbs.h"

namespace spigolo {
namespace {

constexpr std::size_t bytes_per_point = 250;
constexpr std::size_t bytes_per_triangle = 250;

const VerbHelp help = {
    "info",
    "What a file holds: counts, bounds, spacing, noise estimate, attributes; of a CAD "
    "file its faces.",
    "spigolo info scan.ply"};

void print_cad(const std::string& path, const CommonOptions& common, const CommandLine& line) {
  Run run(common);
  run.check_file_size(path);
  const CadFile file = read_cad(path, common);
  Json json = cad_json(path, file);
  json["seconds"] = {{"total", run.total_seconds()}};
  save_parameters(common, help, line.parameters());
  run.print(json, cad_text(path, file));
}

Json info_json(const std::string& path, const ReadReport& seen, const TriangleMesh& mesh,
               const CloudSummary& summary) {
  Json json = {{"file", path}, {"format", seen.format}, {"encoding", seen.encoding}};
  if (!seen.version.empty()) json["format_version"] = seen.version;
  json.update(to_json(summary));
  json["faces"] = seen.faces;
  json["triangles"] = mesh.triangles.size();
  json["attributes"] = attributes_json(mesh.vertices);
  return json;
}

std::string info_text(const std::string& path, const ReadReport& seen, const TriangleMesh& mesh,
                      const CloudSummary& summary) {
  std::string text = "file        " + path + "\nformat      " + seen.format;
  for (const std::string& detail : {seen.version, seen.encoding})
    if (!detail.empty()) text += ", " + detail;
  text += "\n" + summary_text(summary);
  if (seen.faces > 0)
    text += "faces       " + count_text(seen.faces) + " (" + count_text(mesh.triangles.size()) +
            " triangles)\n";
  std::string names;
  for (const Attribute& a : mesh.vertices.attributes)
    names += (names.empty() ? "" : ", ") + a.name + " " + type_name(a.type);
  return text + "attributes  " + (names.empty() ? "none" : names) + "\n";
}

// Triangles that name a vertex twice have no area and no place among the others.
MeshCheck check_triangles(TriangleMesh mesh, Run& run) {
  const std::size_t all = mesh.triangles.size();
  std::erase_if(mesh.triangles,
                [](const Triangle& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
  run.check_memory(mesh.triangles.size(), bytes_per_triangle);
  MeshCheck check = check_mesh(mesh, {}, run.job());
  check.degenerate += all - mesh.triangles.size();
  return check;
}

}  // namespace

void run_info(const std::vector<std::string>& arguments) {
  CommonOptions common;
  std::string path;
  CommandLine line(help, common);
  line.app().add_option("FILE", path, "cloud, mesh or CAD file; - is standard input")->required();
  if (!line.parse(arguments)) return;
  if (is_cad_file(path)) return print_cad(path, common, line);

  Run run(common);
  ReadReport seen;
  TriangleMesh mesh = read_surface(path, run, seen);
  warn(seen, path, run);
  run.check_memory(mesh.vertices.size(), bytes_per_point);
  const CloudSummary summary = summarize(mesh.vertices.points, run.job());
  Json json = info_json(path, seen, mesh, summary);
  std::string text = info_text(path, seen, mesh, summary);
  if (!mesh.triangles.empty()) {
    const MeshCheck check = check_triangles(std::move(mesh), run);
    json["mesh"] = to_json(check);
    text += "mesh        " + check_text(check);
  }
  json["seconds"] = {{"total", run.total_seconds()}};
  save_parameters(common, help, line.parameters());
  run.print(json, text);
}

}  // namespace spigolo
