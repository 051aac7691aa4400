// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/files.cpp
#include "files.h"

#include <utility>

#include "report.h"
#include "spigolo/core/error.h"
#include "spigolo/io/input_bytes.h"
#include "suggest.h"

namespace spigolo {
namespace {

bool holds_faces(FileFormat format) {
  return format == FileFormat::ply || format == FileFormat::obj || format == FileFormat::off ||
         format == FileFormat::stl;
}

}  // namespace

PointCloud read_points(const std::string& path, const Run& run, ReadReport& report) {
  if (path != "-") run.check_file_size(path);
  return read_cloud(path, &report);
}

TriangleMesh read_surface(const std::string& path, const Run& run, ReadReport& report,
                          FileLines* lines) {
  const bool piped = path == "-";
  FileFormat format = piped ? FileFormat::xyz : file_format(path, FileUse::read_cloud);
  if (!piped) run.check_file_size(path);
  const FileBytes file(path);
  const InputBytes input = file.view();
  if (piped && input.text().starts_with("ply")) format = FileFormat::ply;
  if (holds_faces(format)) return read_mesh(input, format, &report, lines);
  return {read_cloud(input, format, &report), {}};
}

FileFormat output_format(const std::string& path, FileFormat of_stdout) {
  if (path == "-") return of_stdout;
  const bool faces_only = lower_extension(path) == ".stl";
  return file_format(path, faces_only ? FileUse::write_mesh : FileUse::write_cloud);
}

AtomicFile staged_surface(const std::string& path, FileFormat format, const TriangleMesh& mesh,
                          Run& run, const WriteOptions& options) {
  const bool with_faces = !mesh.triangles.empty() && holds_faces(format);
  run.job();  // from here on an interrupt waits until the temporary file is gone
  AtomicFile out(path);
  const WriteReport report = with_faces ? write_mesh(out, format, mesh, options)
                                        : write_cloud(out, format, mesh.vertices, options);
  if (!mesh.triangles.empty() && !with_faces)
    run.warn(path + " has no place for faces: " + count_text(mesh.triangles.size()) +
             " triangles are left out");
  if (!report.dropped.empty())
    run.warn(path + " has no place for these attributes: " + joined(report.dropped));
  if (report.rounding > 0)
    run.warn(path + ": coordinates are rounded by up to " + number_text(report.rounding) +
             " in this format");
  return out;
}

void write_surface(const std::string& path, FileFormat format, const TriangleMesh& mesh, Run& run,
                   const WriteOptions& options) {
  AtomicFile out = staged_surface(path, format, mesh, run, options);
  run.job().check();
  out.commit();
}

void warn(const ReadReport& report, const std::string& path, Run& run) {
  for (const std::string& warning : report.warnings) run.warn(path + ": " + warning);
  if (!report.skipped.empty()) run.warn(path + ": not read: " + joined(report.skipped));
}

}  // namespace spigolo
