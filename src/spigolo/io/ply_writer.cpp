// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/ply_writer.cpp
#include "spigolo/io/ply_writer.h"

#include <algorithm>

#include "spigolo/core/error.h"
#include "spigolo/io/names.h"
#include "spigolo/io/ply_header.h"
#include "spigolo/io/text.h"

namespace spigolo {
namespace {

constexpr std::size_t block_rows = 4096;  // rows put together before they are written

std::string header_text(const PointCloud& vertices, std::size_t triangles,
                        std::span<const PlyElement> more, const PlyOptions& options) {
  std::string text =
      options.ascii ? "ply\nformat ascii 1.0\n" : "ply\nformat binary_little_endian 1.0\n";
  for (std::string comment : options.comments) {
    for (char& c : comment)
      if (static_cast<unsigned char>(c) < ' ') c = ' ';
    text += "comment " + comment + "\n";
  }
  const auto property = [&](const std::string& name, ScalarType type) {
    text += std::string("property ") + ply_type_name(type) + " " + name + "\n";
  };
  text += "element vertex " + std::to_string(vertices.size()) + "\n";
  for (const char* axis : {"x", "y", "z"}) property(axis, ScalarType::float64);
  const std::vector<std::string> names = file_names(vertices);
  for (std::size_t a = 0; a < names.size(); ++a) property(names[a], vertices.attributes[a].type);
  if (triangles > 0)
    text +=
        "element face " + std::to_string(triangles) + "\nproperty list uchar int vertex_indices\n";
  for (const PlyElement& element : more) {
    const std::size_t rows = element.columns.empty() ? 0 : element.columns.front().values.size();
    text += "element " + element.name + " " + std::to_string(rows) + "\n";
    for (const Attribute& column : element.columns) property(column.name, column.type);
  }
  return text + "end_header\n";
}

// Rows of scalars: positions, if there are any, then the columns.
void write_binary_rows(AtomicFile& out, std::span<const Vec3> points,
                       std::span<const Attribute> columns) {
  constexpr std::size_t axis_size = sizeof(double);
  std::size_t stride = points.empty() ? 0 : 3 * axis_size;
  for (const Attribute& c : columns) stride += size_of(c.type);
  const std::size_t rows =
      points.empty() && !columns.empty() ? columns.front().values.size() : points.size();
  std::vector<std::byte> block(std::min(rows, block_rows) * stride);
  for (std::size_t begin = 0; begin < rows; begin += block_rows) {
    const std::size_t count = std::min(block_rows, rows - begin);
    std::byte* to = block.data();
    for (std::size_t axis = 0; axis < 3 && !points.empty(); ++axis, to += axis_size)
      store_column(to, stride, ScalarType::float64, count,
                   [&](std::size_t i) { return points[begin + i][axis]; });
    for (const Attribute& c : columns) {
      store_column(to, stride, c.type, count, [&](std::size_t i) { return c.values[begin + i]; });
      to += size_of(c.type);
    }
    out.write({reinterpret_cast<const char*>(block.data()), count * stride});
  }
}

void write_ascii_rows(AtomicFile& out, std::span<const Vec3> points,
                      std::span<const Attribute> columns) {
  const std::size_t rows =
      points.empty() && !columns.empty() ? columns.front().values.size() : points.size();
  std::string line;
  for (std::size_t i = 0; i < rows; ++i) {
    line.clear();
    for (std::size_t axis = 0; axis < 3 && !points.empty(); ++axis) {
      append_number(line, points[i][axis], ScalarType::float64);
      line += ' ';
    }
    for (const Attribute& c : columns) {
      append_number(line, c.values[i], c.type);
      line += ' ';
    }
    line.back() = '\n';
    out.write(line);
  }
}

void write_rows(AtomicFile& out, bool ascii, std::span<const Vec3> points,
                std::span<const Attribute> columns) {
  if (ascii)
    write_ascii_rows(out, points, columns);
  else
    write_binary_rows(out, points, columns);
}

void write_triangles(AtomicFile& out, bool ascii,
                     std::span<const std::array<std::uint32_t, 3>> triangles) {
  std::string row;
  for (const auto& triangle : triangles) {
    row = ascii ? "3" : "\3";
    for (const std::uint32_t corner : triangle) {
      std::byte bytes[sizeof corner];
      store(bytes, corner);
      row += ascii ? " " + std::to_string(corner)
                   : std::string(reinterpret_cast<const char*>(bytes), sizeof bytes);
    }
    if (ascii) row += '\n';
    out.write(row);
  }
}

}  // namespace

void write_ply(AtomicFile& out, const PointCloud& vertices,
               std::span<const std::array<std::uint32_t, 3>> triangles,
               std::span<const PlyElement> more, const PlyOptions& options) {
  validate(vertices);
  out.write(header_text(vertices, triangles.size(), more, options));
  if (vertices.size() > 0) write_rows(out, options.ascii, vertices.points, vertices.attributes);
  write_triangles(out, options.ascii, triangles);
  for (const PlyElement& element : more) {
    for (const Attribute& column : element.columns)
      if (column.values.size() != element.columns.front().values.size())
        throw Error("ply: the columns of element " + element.name + " differ in length");
    write_rows(out, options.ascii, {}, element.columns);
  }
}

}  // namespace spigolo
