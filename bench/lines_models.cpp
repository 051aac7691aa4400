// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/lines_models.cpp - curves of published models, beside the numbers that are right for them
#include <array>

#include "sections.h"
#include "spigolo/io/cloud_file.h"
#include "spigolo/pipeline/lines.h"

namespace spigolo::bench {
namespace {

// Right numbers, counted in the mesh that the vertices come from by a script of a few lines: sides
// whose triangles meet at more than `angle` degrees, joined to curves between vertices where other
// than two of them meet, or two that turn by more than 40 degrees.
struct Model {
  const char* file;
  int curves, closed, corners, angle;
  const char* why;
};

constexpr std::array<Model, 4> models = {{
    {"fandisk.off", 35, 0, 23, 30,
     "the same for every angle from 25 to 40; two curves fade to a free end. At 20 degrees the "
     "facets of a round become edges: 54 curves"},
    {"fandisk_large.off", 35, 0, 23, 30, "the same part; its own mesh is too rough to count in"},
    {"anchor_dense.off", 31, 9, 14, 40,
     "without one spur of two sides; at 30 degrees the mesh's own roughness makes 43"},
    {"couplingdown.off", 55, 46, 6, 40,
     "no judgement: the vertices of a triangulation made for drawing, nearly all of them on edges, "
     "are not samples of its faces"},
}};

std::vector<std::string> row_of(const Model& model, const std::filesystem::path& data) {
  const Lines lines = find_lines(read_cloud(data / model.file).points);
  std::array<std::size_t, curve_shape_names.size()> of{};
  std::size_t edges = 0, closed = 0;
  for (const FeatureCurve& curve : lines.network.curves) {
    if (curve.kind != CurveKind::edge) continue;
    ++edges;
    closed += curve.closed;
    ++of[static_cast<std::size_t>(curve.shape)];
  }
  const auto both = [](auto a, auto b, auto c) {
    return std::to_string(a) + " / " + std::to_string(b) + " / " + std::to_string(c);
  };
  return {std::filesystem::path(model.file).stem().string(),
          both(model.curves, model.closed, model.corners),
          both(edges, closed, lines.network.corners.size()),
          std::to_string(of[static_cast<std::size_t>(CurveShape::line)]),
          std::to_string(of[static_cast<std::size_t>(CurveShape::circle)]),
          std::to_string(of[static_cast<std::size_t>(CurveShape::arc)]),
          std::to_string(of[static_cast<std::size_t>(CurveShape::spline)]),
          model.why};
}

}  // namespace

void judged_models(Report& report, const std::filesystem::path& data) {
  report.heading(3, "Published models");
  report.text(
      "Their vertices as clouds: curves / closed ones / corners. What is right was counted in the "
      "meshes, by the angles between their triangles.");
  std::vector<std::vector<std::string>> rows;
  for (const Model& model : models) rows.push_back(row_of(model, data));
  report.table(
      {"cloud", "right", "found", "lines", "circles", "arcs", "splines", "how it was counted"},
      rows);
}

}  // namespace spigolo::bench
