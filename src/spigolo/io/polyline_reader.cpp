// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/polyline_reader.cpp
#include "spigolo/io/polyline_reader.h"

#include <algorithm>

#include "spigolo/core/error.h"
#include "spigolo/io/ply_body.h"
#include "spigolo/io/text.h"

namespace spigolo {
namespace {

using Columns = std::vector<std::vector<double>>;

// The column of that name, or null.
const std::vector<double>* column(const PlyElementHeader& element, const Columns& columns,
                                  std::string_view name) {
  for (std::size_t p = 0; p < element.properties.size(); ++p)
    if (element.properties[p].name == name && !element.properties[p].is_list()) return &columns[p];
  return nullptr;
}

void take_vertices(const PlyElementHeader& element, const Columns& columns, Polylines& result) {
  const auto *x = column(element, columns, "x"), *y = column(element, columns, "y"),
             *z = column(element, columns, "z");
  if (!x || !y || !z) return;
  result.points.resize(element.count);
  for (std::size_t i = 0; i < result.points.size(); ++i)
    result.points[i] = {(*x)[i], (*y)[i], (*z)[i]};
}

void take_edges(const InputBytes& input, const PlyElementHeader& element, const Columns& columns,
                Polylines& result) {
  const auto *from = column(element, columns, "vertex1"), *to = column(element, columns, "vertex2");
  const auto* curve = column(element, columns, "scalar_curve");
  if (!from || !to) return;
  const auto vertex = [&](double value) {
    if (!(value >= 0) || value >= static_cast<double>(result.points.size()))
      throw InputError(input.name, "element edge", "an edge names a vertex that does not exist");
    return static_cast<std::uint32_t>(value);
  };
  for (std::size_t i = 0; i < from->size(); ++i) {
    const std::uint32_t a = vertex((*from)[i]), b = vertex((*to)[i]);
    const bool same = i > 0 && (!curve || (*curve)[i] == (*curve)[i - 1]);
    if (!same || result.lines.back().back() != a) result.lines.push_back({a});
    result.lines.back().push_back(b);
  }
}

Polylines read_ply_lines(const InputBytes& input) {
  const PlyHeader header = parse_ply_header(input);
  PlyBody body(input, header);
  Polylines result;
  for (const PlyElementHeader& element : header.elements) {
    if (element.name == "vertex")
      take_vertices(element, body.read_columns(element), result);
    else if (element.name == "edge")
      take_edges(input, element, body.read_columns(element), result);
    else
      body.skip(element);
  }
  return result;
}

void take_obj_line(const LineReader& lines, std::string_view rest, Polylines& result) {
  auto& line = result.lines.emplace_back();
  for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest)) {
    std::uint64_t number = 0;
    word = word.substr(0, word.find('/'));
    if (!parse_count(word, number) || number == 0 || number > result.points.size())
      lines.fail("'" + excerpt(word) + "' names no vertex above");
    line.push_back(static_cast<std::uint32_t>(number - 1));
  }
  if (line.size() < 2) result.lines.pop_back();
}

Polylines read_obj_lines(const InputBytes& input) {
  Polylines result;
  LineReader lines(input);
  std::string_view line;
  while (lines.next_content(line)) {
    const std::string_view keyword = next_word(line);
    if (keyword == "l") take_obj_line(lines, line, result);
    if (keyword != "v") continue;
    Vec3& p = result.points.emplace_back();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::string_view word = next_word(line);
      const char* at = word.data();
      if (word.empty() || !parse_number(at, word.data() + word.size(), p[axis]))
        lines.fail("'" + excerpt(word) + "' is not a number");
    }
  }
  return result;
}

}  // namespace

Polylines read_polylines(const InputBytes& input, FileFormat format) {
  if (format == FileFormat::ply) return read_ply_lines(input);
  if (format == FileFormat::obj) return read_obj_lines(input);
  return {};
}

}  // namespace spigolo
