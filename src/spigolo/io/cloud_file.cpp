// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/cloud_file.cpp
#include "spigolo/io/cloud_file.h"

#include <new>
#include <utility>

#include "spigolo/core/error.h"
#include "spigolo/io/las_reader.h"
#include "spigolo/io/las_writer.h"
#include "spigolo/io/mesh_writers.h"
#include "spigolo/io/obj_reader.h"
#include "spigolo/io/off_reader.h"
#include "spigolo/io/pcd_reader.h"
#include "spigolo/io/pcd_writer.h"
#include "spigolo/io/ply_reader.h"
#include "spigolo/io/ply_writer.h"
#include "spigolo/io/stl_reader.h"
#include "spigolo/io/text_reader.h"
#include "spigolo/io/text_writer.h"

namespace spigolo {
namespace {

bool begins_as_ply(const InputBytes& input) {
  const std::string_view start = input.text().substr(0, 4);
  return start == "ply\n" || start == "ply\r";
}

// The table reader takes almost anything for names; these it should not.
void refuse_foreign_text(const InputBytes& input) {
  const std::string_view text = input.text();
  const char* is = nullptr;
  if (begins_as_ply(input)) is = "PLY file; give it the ending .ply";
  if (text.substr(0, 4) == "LASF") is = "LAS file; give it the ending .las";
  if (text.substr(0, 6) == "# .PCD") is = "PCD file; give it the ending .pcd";
  if (is != nullptr) throw InputError(input.name, "byte 0", std::string("this is a ") + is);
}

PointCloud read_table(const InputBytes& input, bool is_pts, ReadReport& report) {
  refuse_foreign_text(input);
  return read_text(input, is_pts, report);
}

TriangleMesh read_polygons(const InputBytes& input, FileFormat format, bool with_faces,
                           ReadReport& report, FileLines* lines = nullptr) {
  switch (format) {
    case FileFormat::ply:
      return read_ply(input, with_faces, report, lines);
    case FileFormat::obj:
      return read_obj(input, with_faces, report, lines);
    case FileFormat::off:
      return read_off(input, with_faces, report);
    case FileFormat::stl:
      return read_stl(input, with_faces, report);
    default:
      throw UsageError(input.name + ": this format holds no mesh; known are " +
                       known_endings(FileUse::read_mesh));
  }
}

PointCloud read_points(const InputBytes& input, FileFormat format, ReadReport& report) {
  switch (format) {
    case FileFormat::xyz:
    case FileFormat::csv:
      return read_table(input, false, report);
    case FileFormat::pts:
      return read_table(input, true, report);
    case FileFormat::pcd:
      return read_pcd(input, report);
    case FileFormat::las:
      return read_las(input, report);
    default:
      return std::move(read_polygons(input, format, false, report).vertices);
  }
}

// Runs a reader; memory that runs out becomes an error that names the file.
template <class Read>
auto guarded(const InputBytes& input, ReadReport* report, Read read) {
  ReadReport own;
  try {
    return read(report != nullptr ? *report : own);
  } catch (const std::bad_alloc&) {
    throw MemoryError(input.name + ": its points do not fit into memory; cut it into parts");
  }
}

}  // namespace

PointCloud read_cloud(const InputBytes& input, FileFormat format, ReadReport* report) {
  return guarded(input, report, [&](ReadReport& r) { return read_points(input, format, r); });
}

PointCloud read_cloud(const std::filesystem::path& path, ReadReport* report) {
  const bool piped = path == "-";
  FileFormat format = piped ? FileFormat::xyz : file_format(path, FileUse::read_cloud);
  const FileBytes file(path);
  const InputBytes input = file.view();
  if (piped && begins_as_ply(input)) format = FileFormat::ply;
  return read_cloud(input, format, report);
}

TriangleMesh read_mesh(const InputBytes& input, FileFormat format, ReadReport* report,
                       FileLines* lines) {
  return guarded(input, report,
                 [&](ReadReport& r) { return read_polygons(input, format, true, r, lines); });
}

TriangleMesh read_mesh(const std::filesystem::path& path, ReadReport* report) {
  const FileFormat format = path == "-" ? FileFormat::ply : file_format(path, FileUse::read_mesh);
  const FileBytes file(path);
  return read_mesh(file.view(), format, report);
}

WriteReport write_cloud(AtomicFile& out, FileFormat format, const PointCloud& cloud,
                        const WriteOptions& options) {
  WriteReport report;
  switch (format) {
    case FileFormat::ply:
      write_ply(out, cloud, {}, {}, {options.ascii, options.comments});
      break;
    case FileFormat::xyz:
      write_text(out, cloud, TextDialect::xyz, report);
      break;
    case FileFormat::csv:
      write_text(out, cloud, TextDialect::csv, report);
      break;
    case FileFormat::pts:
      write_text(out, cloud, TextDialect::pts, report);
      break;
    case FileFormat::pcd:
      write_pcd(out, cloud, options);
      break;
    case FileFormat::las:
      write_las(out, cloud, options, report);
      break;
    default:
      return write_mesh(out, format, {cloud, {}}, options);
  }
  return report;
}

WriteReport write_cloud(const std::filesystem::path& path, const PointCloud& cloud,
                        const WriteOptions& options) {
  const FileFormat format = path == "-" ? FileFormat::xyz : file_format(path, FileUse::write_cloud);
  AtomicFile out(path);
  WriteReport report = write_cloud(out, format, cloud, options);
  out.commit();
  return report;
}

WriteReport write_mesh(AtomicFile& out, FileFormat format, const TriangleMesh& mesh,
                       const WriteOptions& options) {
  WriteReport report;
  validate(mesh);
  switch (format) {
    case FileFormat::ply:
      write_ply(out, mesh.vertices, mesh.triangles, {}, {options.ascii, options.comments});
      break;
    case FileFormat::obj:
      write_obj(out, mesh, report);
      break;
    case FileFormat::off:
      write_off(out, mesh, report);
      break;
    case FileFormat::stl:
      write_stl(out, mesh, options.ascii, report);
      break;
    default:
      throw UsageError("this format holds no mesh; known are " +
                       known_endings(FileUse::write_mesh));
  }
  return report;
}

WriteReport write_mesh(const std::filesystem::path& path, const TriangleMesh& mesh,
                       const WriteOptions& options) {
  const FileFormat format = path == "-" ? FileFormat::ply : file_format(path, FileUse::write_mesh);
  AtomicFile out(path);
  WriteReport report = write_mesh(out, format, mesh, options);
  out.commit();
  return report;
}

}  // namespace spigolo
