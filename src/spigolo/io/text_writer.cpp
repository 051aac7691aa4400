// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/text_writer.cpp
#include "spigolo/io/text_writer.h"

#include <algorithm>

#include "spigolo/io/names.h"
#include "spigolo/io/text.h"

namespace spigolo {
namespace {

using Columns = std::vector<const Attribute*>;

// What a .pts file has room for, in its order.
Columns pts_columns(const PointCloud& cloud, WriteReport& report) {
  Columns columns;
  const Attribute* const red = cloud.find("red");
  const bool colour = red && cloud.find("green") && cloud.find("blue");
  if (const Attribute* intensity = cloud.find("intensity")) columns.push_back(intensity);
  if (colour) columns.insert(columns.end(), {red, cloud.find("green"), cloud.find("blue")});
  for (const Attribute& a : cloud.attributes)
    if (std::find(columns.begin(), columns.end(), &a) == columns.end())
      report.dropped.push_back(a.name);
  return columns;
}

Columns all_columns(const PointCloud& cloud) {
  Columns columns;
  for (const Attribute& a : cloud.attributes) columns.push_back(&a);
  return columns;
}

std::string first_line(const PointCloud& cloud, TextDialect dialect) {
  if (dialect == TextDialect::pts) return std::to_string(cloud.size()) + "\n";
  if (dialect == TextDialect::xyz && cloud.attributes.empty()) return "";
  const char separator = dialect == TextDialect::csv ? ',' : ' ';
  std::string line = dialect == TextDialect::csv ? "x,y,z" : "# x y z";
  for (std::string name : file_names(cloud)) {
    std::replace_if(
        name.begin(), name.end(), [](char c) { return c == ',' || c == ';' || c == '"'; }, '_');
    line += separator + name;
  }
  return line + "\n";
}

}  // namespace

void write_text(AtomicFile& out, const PointCloud& cloud, TextDialect dialect,
                WriteReport& report) {
  validate(cloud);
  const char separator = dialect == TextDialect::csv ? ',' : ' ';
  const Columns columns =
      dialect == TextDialect::pts ? pts_columns(cloud, report) : all_columns(cloud);
  std::string line = first_line(cloud, dialect);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      append_number(line, cloud.points[i][axis], ScalarType::float64);
      line += separator;
    }
    for (const Attribute* column : columns) {
      append_number(line, column->values[i], ScalarType::float64);
      line += separator;
    }
    line.back() = '\n';
    out.write(line);
    line.clear();
  }
  out.write(line);
}

}  // namespace spigolo
