// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/mesh_writers.cpp
#include "spigolo/io/mesh_writers.h"

#include <algorithm>
#include <limits>

#include "spigolo/core/error.h"
#include "spigolo/io/colours.h"
#include "spigolo/io/scalar.h"
#include "spigolo/io/text.h"

namespace spigolo {
namespace {

constexpr std::size_t stl_head = 80, stl_record = 50;

void append_position(std::string& out, const Vec3& p) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (axis > 0) out += ' ';
    append_number(out, p[axis], ScalarType::float64);
  }
}

void report_dropped(const PointCloud& cloud, const std::vector<const Attribute*>& kept,
                    WriteReport& report) {
  for (const Attribute& a : cloud.attributes)
    if (std::find(kept.begin(), kept.end(), &a) == kept.end()) report.dropped.push_back(a.name);
}

Vec3 facet_normal(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& t) {
  const auto& p = mesh.vertices.points;
  return normalized(cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]));
}

void write_ascii_stl(AtomicFile& out, const TriangleMesh& mesh) {
  out.write("solid spigolo\n");
  std::string facet;
  for (const auto& t : mesh.triangles) {
    facet = "facet normal ";
    append_position(facet, facet_normal(mesh, t));
    facet += "\nouter loop\n";
    for (const std::uint32_t corner : t) {
      facet += "vertex ";
      append_position(facet, mesh.vertices.points[corner]);
      facet += '\n';
    }
    facet += "endloop\nendfacet\n";
    out.write(facet);
  }
  out.write("endsolid spigolo\n");
}

std::byte* store_vector(std::byte* to, const Vec3& v) {
  for (std::size_t axis = 0; axis < 3; ++axis, to += sizeof(float))
    store(to, narrow<float>(v[axis]));
  return to;
}

void write_binary_stl(AtomicFile& out, const TriangleMesh& mesh) {
  std::string head = "binary STL by spigolo";
  head.resize(stl_head, ' ');
  out.write(head);
  std::byte record[stl_record] = {};
  store(record, static_cast<std::uint32_t>(mesh.triangles.size()));
  out.write({reinterpret_cast<const char*>(record), sizeof(std::uint32_t)});
  for (const auto& t : mesh.triangles) {
    std::byte* to = store_vector(record, facet_normal(mesh, t));
    for (const std::uint32_t corner : t) to = store_vector(to, mesh.vertices.points[corner]);
    store(to, std::uint16_t{0});
    out.write({reinterpret_cast<const char*>(record), stl_record});
  }
}

}  // namespace

void write_obj(AtomicFile& out, const TriangleMesh& mesh, WriteReport& report) {
  const PointCloud& cloud = mesh.vertices;
  const std::vector<const Attribute*> colours = find_colours(cloud);
  report_dropped(cloud, colours, report);
  std::string line;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    line = "v ";
    append_position(line, cloud.points[i]);
    for (const Attribute* c : colours) {
      line += ' ';
      append_number(line, c->values[i] / 255, ScalarType::float32);
    }
    line += '\n';
    out.write(line);
  }
  for (const auto& t : mesh.triangles) {
    line = "f";
    for (const std::uint32_t corner : t) line += " " + std::to_string(std::uint64_t{corner} + 1);
    line += '\n';
    out.write(line);
  }
}

void write_off(AtomicFile& out, const TriangleMesh& mesh, WriteReport& report) {
  const PointCloud& cloud = mesh.vertices;
  const std::vector<const Attribute*> colours = find_colours(cloud);
  report_dropped(cloud, colours, report);
  out.write((colours.empty() ? "OFF\n" : "COFF\n") + std::to_string(cloud.size()) + " " +
            std::to_string(mesh.triangles.size()) + " 0\n");
  std::string line;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    line.clear();
    append_position(line, cloud.points[i]);
    for (const Attribute* c : colours) {
      line += ' ';
      append_number(line, c->values[i], ScalarType::uint8);
    }
    line += colours.empty() ? "\n" : " 255\n";
    out.write(line);
  }
  for (const auto& t : mesh.triangles)
    out.write("3 " + std::to_string(t[0]) + " " + std::to_string(t[1]) + " " +
              std::to_string(t[2]) + "\n");
}

void write_stl(AtomicFile& out, const TriangleMesh& mesh, bool ascii, WriteReport& report) {
  if (mesh.triangles.empty())
    throw UsageError("STL holds triangles only and there are none; write .ply or .obj instead");
  if (!ascii && mesh.triangles.size() > std::numeric_limits<std::uint32_t>::max())
    throw UsageError("binary STL holds 2^32 - 1 triangles at most; write .ply instead");
  report_dropped(mesh.vertices, {}, report);
  if (ascii) {
    write_ascii_stl(out, mesh);
    return;
  }
  for (const Vec3& p : mesh.vertices.points)
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (std::isfinite(p[axis]))
        report.rounding = std::max(report.rounding,
                                   std::abs(p[axis] - static_cast<double>(narrow<float>(p[axis]))));
  write_binary_stl(out, mesh);
}

}  // namespace spigolo
