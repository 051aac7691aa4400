// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/curve_writers.cpp - which writer for which ending; OBJ, PLY and CSV
#include "spigolo/io/curve_writers.h"

#include <algorithm>
#include <array>

#include "spigolo/core/error.h"
#include "spigolo/io/curve_tables.h"
#include "spigolo/io/ply_writer.h"
#include "spigolo/io/text.h"

namespace spigolo {
namespace {

constexpr std::array<const char*, 6> unit_names = {"none", "mm", "cm", "m", "in", "ft"};

struct Ending {
  const char* text;
  CurveFormat format;
};
constexpr std::array<Ending, 6> endings = {{{".dxf", CurveFormat::dxf},
                                            {".obj", CurveFormat::obj},
                                            {".ply", CurveFormat::ply},
                                            {".vtp", CurveFormat::vtp},
                                            {".json", CurveFormat::json},
                                            {".csv", CurveFormat::csv}}};

void append_row(std::string& text, const std::vector<double>& values) {
  for (const double value : values) {
    text += ',';
    append_double(text, value);
  }
}

}  // namespace

LengthUnit length_unit(const std::string& name) {
  const auto found = std::find(unit_names.begin(), unit_names.end(), name);
  if (found == unit_names.end())
    throw UsageError("the unit '" + name + "' is not known; there are none, mm, cm, m, in, ft");
  return static_cast<LengthUnit>(found - unit_names.begin());
}

const char* unit_name(LengthUnit unit) { return unit_names[static_cast<std::size_t>(unit)]; }

CurveFormat curve_format(const std::filesystem::path& path) {
  const std::string ending = lower(path.extension().string());
  for (const Ending& e : endings)
    if (ending == e.text) return e.format;
  throw UsageError(path.string() + ": the name " +
                   (ending.empty() ? "has no ending" : "has the unknown ending " + ending) +
                   "; lines go to .dxf .step .obj .ply .vtp .json .csv");
}

std::string obj_text(const FeatureCurves& network) {
  const CurveVertices table = shared_vertices(network);
  std::string text = "# feature curves by spigolo\n";
  for (const Vec3& p : table.points) {
    text += 'v';
    for (std::size_t axis = 0; axis < 3; ++axis) {
      text += ' ';
      append_double(text, p[axis]);
    }
    text += '\n';
  }
  for (std::size_t c = 0; c < table.curve.size(); ++c) {
    text += "g curve_" + std::to_string(c) + "\nl";
    for (const std::uint32_t v : table.curve[c]) text += ' ' + std::to_string(v + 1);
    text += '\n';
  }
  return text;
}

void write_curves_ply(AtomicFile& out, const FeatureCurves& network) {
  const CurveVertices table = shared_vertices(network);
  PlyElement edges{"edge",
                   {{"vertex1", ScalarType::int32, {}},
                    {"vertex2", ScalarType::int32, {}},
                    {"scalar_curve", ScalarType::float32, {}},
                    {"scalar_angle", ScalarType::float32, {}}}};
  for (std::size_t c = 0; c < table.curve.size(); ++c)
    for (std::size_t i = 1; i < table.curve[c].size(); ++i) {
      const std::uint32_t a = table.curve[c][i - 1], b = table.curve[c][i];
      const auto& angle = network.curves[c].angle;
      const double mean = (angle[i - 1] + angle[i % angle.size()]) / 2;
      edges.columns[0].values.push_back(a);
      edges.columns[1].values.push_back(b);
      edges.columns[2].values.push_back(static_cast<double>(c));
      edges.columns[3].values.push_back(degrees(mean));
    }
  PointCloud vertices;
  vertices.points = table.points;
  write_ply(out, vertices, {}, {&edges, 1}, {false, {"feature curves by spigolo"}});
}

std::string curves_csv(const FeatureCurves& network) {
  std::string text =
      "id,kind,shape,closed,convex,bridged,corner_a,corner_b,length,angle_min_deg,angle_mean_deg,"
      "angle_max_deg,residual,confidence,radius,center_x,center_y,center_z,axis_x,axis_y,axis_z\n";
  for (std::size_t c = 0; c < network.curves.size(); ++c) {
    const FeatureCurve& curve = network.curves[c];
    const AngleRange angle = angle_range(curve);
    text += std::to_string(c) + ',' + kind_name(curve.kind) + ',' +
            curve_shape_names[static_cast<std::size_t>(curve.shape)] + ',' +
            (curve.closed ? "1," : "0,") + std::to_string(curve.convex) +
            (curve.bridged ? ",1," : ",0,") + std::to_string(curve.corner[0]) + ',' +
            std::to_string(curve.corner[1]);
    append_row(text, {curve.length(), degrees(angle.min), degrees(angle.mean), degrees(angle.max),
                      curve.residual, curve.confidence});
    if (curve.radius > 0)
      append_row(text, {curve.radius, curve.center.x, curve.center.y, curve.center.z, curve.axis.x,
                        curve.axis.y, curve.axis.z});
    else
      text += ",,,,,,,";
    text += '\n';
  }
  return text;
}

void write_curves(AtomicFile& out, CurveFormat format, const FeatureCurves& network,
                  const CurveFileOptions& options) {
  switch (format) {
    case CurveFormat::dxf:
      return out.write(dxf_text(network, options));
    case CurveFormat::obj:
      return out.write(obj_text(network));
    case CurveFormat::ply:
      return write_curves_ply(out, network);
    case CurveFormat::vtp:
      return out.write(vtp_text(network));
    case CurveFormat::json:
      return out.write(curves_json(network, options));
    case CurveFormat::csv:
      return out.write(curves_csv(network));
  }
}

}  // namespace spigolo
