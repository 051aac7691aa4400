// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/ply_reader.cpp
#include "spigolo/io/ply_reader.h"

#include <algorithm>
#include <array>
#include <utility>

#include "spigolo/core/error.h"
#include "spigolo/io/names.h"
#include "spigolo/io/ply_body.h"
#include "spigolo/io/polygons.h"

namespace spigolo {
namespace {

constexpr std::array<const char*, 3> axis_names = {"x", "y", "z"};

// Index of the first property that `wanted` accepts, or their number.
template <class Predicate>
std::size_t find_property(const PlyElementHeader& element, Predicate wanted) {
  const auto& all = element.properties;
  return static_cast<std::size_t>(std::find_if(all.begin(), all.end(), wanted) - all.begin());
}

std::size_t find_scalar(const PlyElementHeader& element, std::string_view name) {
  return find_property(element,
                       [&](const PlyProperty& p) { return p.name == name && !p.is_list(); });
}

std::size_t find_polygon(const PlyElementHeader& element) {
  return find_property(element, [](const PlyProperty& p) {
    return p.is_list() && (p.name == "vertex_indices" || p.name == "vertex_index");
  });
}

// Walks the elements of one file and keeps what is wanted.
class PlyReader {
 public:
  PlyReader(const InputBytes& input, bool with_faces, ReadReport& report, FileLines* lines)
      : input_(input),
        header_(parse_ply_header(input)),
        body_(input, header_),
        with_faces_(with_faces),
        report_(report),
        lines_(lines) {}

  TriangleMesh read() {
    report_.format = "ply";
    report_.encoding = header_.ascii                     ? "ascii"
                       : header_.order == ByteOrder::big ? "binary_big_endian"
                                                         : "binary_little_endian";
    for (const PlyElementHeader& element : header_.elements) {
      if (element.name == "vertex" && !has_vertices_)
        read_vertices(element);
      else if (element.name == "face")
        read_faces(element);
      else if (element.name == "edge" && lines_ != nullptr)
        read_edges(element);
      else
        skip(element);
    }
    finish();
    return std::move(mesh_);
  }

 private:
  void read_vertices(const PlyElementHeader& element) {
    std::array<std::size_t, 3> axes{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      axes[axis] = find_scalar(element, axis_names[axis]);
      if (axes[axis] == element.properties.size())
        throw InputError(input_.name, "header",
                         std::string("the element 'vertex' has no property '") + axis_names[axis] +
                             "'; it holds no points");
    }
    std::vector<std::vector<double>> columns = body_.read_columns(element);
    PointCloud& cloud = mesh_.vertices;
    cloud.points.resize(element.count);
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t i = 0; i < cloud.size(); ++i) cloud.points[i][axis] = columns[axes[axis]][i];
    for (const std::size_t axis : axes) columns[axis] = {};
    UniqueNames unique{"x", "y", "z"};
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const PlyProperty& property = element.properties[p];
      if (property.is_list())
        report_.skipped.push_back("list property " + property.name + " of vertex");
      else if (std::find(axes.begin(), axes.end(), p) == axes.end())
        cloud.attributes.push_back({unique(property.name), property.type, std::move(columns[p])});
    }
    report_.points = element.count;
    has_vertices_ = true;
  }

  void read_faces(const PlyElementHeader& element) {
    report_.faces += element.count;
    const std::size_t polygon = find_polygon(element);
    if (!with_faces_ || polygon == element.properties.size()) {
      body_.skip(element);
      return;
    }
    body_.read_lists(element, polygon, [&](std::span<const std::uint32_t> corners) {
      for (const std::uint32_t c : corners) largest_ = std::max<std::uint64_t>(largest_, c + 1ull);
      fans_.add(corners);
    });
  }

  void read_edges(const PlyElementHeader& element) {
    report_.lines += element.count;
    const std::size_t ends[] = {find_scalar(element, "vertex1"), find_scalar(element, "vertex2")};
    const std::vector<std::vector<double>> columns = body_.read_columns(element);
    if (std::max(ends[0], ends[1]) == element.properties.size()) {
      report_.warnings.push_back("the element 'edge' has no vertex1 and vertex2; it is not read");
      return;
    }
    const std::size_t curve = find_scalar(element, "scalar_curve");
    const bool named = curve < element.properties.size();
    for (std::size_t i = 0; i < element.count; ++i) {
      const std::uint32_t from = vertex_index(columns[ends[0]][i]),
                          to = vertex_index(columns[ends[1]][i]);
      const bool same = i > 0 && (!named || columns[curve][i] == columns[curve][i - 1]);
      if (!same || lines_->back().back() != from) lines_->push_back({from});
      lines_->back().push_back(to);
    }
  }

  std::uint32_t vertex_index(double value) {
    if (!(value >= 0 && value < 0xffffffff))
      throw InputError(input_.name, "element edge", "an edge names a vertex that cannot be");
    const auto index = static_cast<std::uint32_t>(value);
    largest_edge_ = std::max<std::uint64_t>(largest_edge_, index + 1ull);
    return index;
  }

  void skip(const PlyElementHeader& element) {
    report_.skipped.push_back("element " + element.name);
    body_.skip(element);
  }

  void finish() {
    if (!has_vertices_)
      throw InputError(input_.name, "header", "there is no element 'vertex'; it holds no points");
    if (largest_ > mesh_.vertices.size())
      throw InputError(input_.name, "element face",
                       "a face names vertex " + std::to_string(largest_ - 1) + " of " +
                           std::to_string(mesh_.vertices.size()) + "; the file is damaged");
    if (largest_edge_ > mesh_.vertices.size())
      throw InputError(input_.name, "element edge",
                       "an edge names vertex " + std::to_string(largest_edge_ - 1) + " of " +
                           std::to_string(mesh_.vertices.size()) + "; the file is damaged");
    if (!body_.at_end()) report_.warnings.push_back("there is more data behind the last element");
    mesh_.triangles = fans_.take(report_);
  }

  const InputBytes& input_;
  PlyHeader header_;
  PlyBody body_;
  bool with_faces_;
  ReadReport& report_;
  FileLines* lines_;
  TriangleMesh mesh_;
  PolygonFans fans_;
  bool has_vertices_ = false;
  std::uint64_t largest_ = 0;       // one more than the largest index a face names
  std::uint64_t largest_edge_ = 0;  // the same of edges
};

}  // namespace

TriangleMesh read_ply(const InputBytes& input, bool with_faces, ReadReport& report,
                      FileLines* lines) {
  return PlyReader(input, with_faces, report, lines).read();
}

}  // namespace spigolo
