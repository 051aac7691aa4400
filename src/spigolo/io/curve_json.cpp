// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/curve_json.cpp - the JSON of docs/lines.schema.json, and VTK's PolyData
#include <string_view>

#include "spigolo/io/curve_tables.h"
#include "spigolo/io/curve_writers.h"

namespace spigolo {
namespace {

constexpr const char* schema_name = "spigolo-lines-1";

template <class Items, class Append>
void append_list(std::string& out, const Items& items, std::string_view between,
                 const Append& append) {
  bool first = true;
  for (const auto& item : items) {
    if (!first) out += between;
    first = false;
    append(item);
  }
}

void append_array(std::string& out, const std::vector<double>& values) {
  out += '[';
  append_list(out, values, ",", [&](double v) { append_double(out, v); });
  out += ']';
}

void append_vector(std::string& out, const Vec3& v) { append_array(out, {v.x, v.y, v.z}); }

void append_vectors(std::string& out, const std::vector<Vec3>& vectors) {
  out += '[';
  append_list(out, vectors, ",", [&](const Vec3& v) { append_vector(out, v); });
  out += ']';
}

void append_field(std::string& out, std::string_view name, double value) {
  out.append(",\"").append(name).append("\":");
  append_double(out, value);
}

const char* truth(bool value) { return value ? "true" : "false"; }

void append_shape(std::string& out, const FeatureCurve& curve) {
  out.append(",\"shape\":{\"type\":\"")
      .append(curve_shape_names[static_cast<std::size_t>(curve.shape)])
      .append("\"");
  if (curve.radius > 0) {
    out += ",\"center\":";
    append_vector(out, curve.center);
    out += ",\"axis\":";
    append_vector(out, curve.axis);
    append_field(out, "radius", curve.radius);
  }
  out += '}';
}

void append_spline(std::string& out, const FeatureCurve& curve) {
  const RationalSpline spline = rational_spline(curve);
  out += ",\n \"spline\":{\"degree\":" + std::to_string(spline.degree) + ",\"knots\":";
  append_array(out, spline.knots);
  out += ",\"poles\":";
  append_vectors(out, spline.poles);
  out += ",\"weights\":";
  append_array(out, spline.weights);
  out += '}';
}

void append_curve(std::string& out, std::size_t id, const FeatureCurve& curve) {
  const AngleRange angle = angle_range(curve);
  out += "{\"id\":" + std::to_string(id) + ",\"kind\":\"" + kind_name(curve.kind) + "\"";
  out.append(",\"closed\":").append(truth(curve.closed));
  out += ",\"corners\":[" + std::to_string(curve.corner[0]) + "," +
         std::to_string(curve.corner[1]) + "]";
  append_field(out, "length", curve.length());
  out += ",\"angle_deg\":{\"min\":";
  append_double(out, degrees(angle.min));
  append_field(out, "mean", degrees(angle.mean));
  append_field(out, "max", degrees(angle.max));
  out += "},\"convex\":" + std::to_string(curve.convex);
  append_field(out, "residual", curve.residual);
  append_field(out, "confidence", curve.confidence);
  out.append(",\"bridged\":").append(truth(curve.bridged));
  append_shape(out, curve);
  out += ",\n \"polyline\":";
  append_vectors(out, curve.points);
  append_spline(out, curve);
  out += '}';
}

// One <DataArray> of VTK's XML.
class DataArray {
 public:
  DataArray(std::string& out, std::string_view type, std::string_view name, int components)
      : out_(out) {
    out_.append("<DataArray type=\"").append(type).append("\" Name=\"").append(name);
    out_ += "\" NumberOfComponents=\"" + std::to_string(components) + "\" format=\"ascii\">\n";
  }
  ~DataArray() { out_ += "</DataArray>\n"; }
  DataArray(const DataArray&) = delete;
  DataArray& operator=(const DataArray&) = delete;
  void add(double value) {
    append_double(out_, value);
    out_ += '\n';
  }
  void add(std::size_t value) { out_ += std::to_string(value) + '\n'; }

 private:
  std::string& out_;
};

void append_cells(std::string& out, std::string_view element,
                  const std::vector<std::vector<std::uint32_t>>& rows) {
  out.append("<").append(element).append(">\n");
  {
    DataArray connectivity(out, "Int64", "connectivity", 1);
    for (const auto& row : rows)
      for (const std::uint32_t v : row) connectivity.add(std::size_t{v});
  }
  {
    DataArray offsets(out, "Int64", "offsets", 1);
    std::size_t end = 0;
    for (const auto& row : rows) offsets.add(end += row.size());
  }
  out.append("</").append(element).append(">\n");
}

// One value a cell: the corners' first, then the curves'.
template <class Value>
void append_cell_data(std::string& out, const FeatureCurves& network, std::string_view name,
                      const Value& value) {
  DataArray array(out, "Float64", name, 1);
  for (std::size_t k = 0; k < network.corners.size(); ++k) array.add(-1.0);
  for (std::size_t c = 0; c < network.curves.size(); ++c) array.add(value(c));
}

void append_cell_arrays(std::string& out, const FeatureCurves& network) {
  const auto& curves = network.curves;
  out += "<CellData>\n";
  append_cell_data(out, network, "curve", [](std::size_t c) { return static_cast<double>(c); });
  append_cell_data(out, network, "convex",
                   [&](std::size_t c) { return static_cast<double>(curves[c].convex); });
  append_cell_data(out, network, "border",
                   [&](std::size_t c) { return curves[c].kind == CurveKind::border ? 1.0 : 0.0; });
  append_cell_data(out, network, "length", [&](std::size_t c) { return curves[c].length(); });
  out += "</CellData>\n";
}

}  // namespace

std::string curves_json(const FeatureCurves& network, const CurveFileOptions& options) {
  std::string out = std::string("{\"schema\":\"") + schema_name + "\",\"units\":\"" +
                    unit_name(options.unit) + "\"";
  append_field(out, "spacing", options.spacing);
  out += ",\n\"corners\":[";
  std::size_t id = 0;
  append_list(out, network.corners, ",\n", [&](const FeatureCorner& corner) {
    out += "{\"id\":" + std::to_string(id++);
    append_field(out, "x", corner.position.x);
    append_field(out, "y", corner.position.y);
    append_field(out, "z", corner.position.z);
    out += ",\"valence\":" + std::to_string(corner.valence) + "}";
  });
  out += "],\n\"curves\":[";
  id = 0;
  append_list(out, network.curves, ",\n",
              [&](const FeatureCurve& curve) { append_curve(out, id++, curve); });
  return out + "]}\n";
}

std::string vtp_text(const FeatureCurves& network) {
  const CurveVertices table = shared_vertices(network);
  std::string out =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
      "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<PolyData>\n<Piece NumberOfPoints=\"";
  out += std::to_string(table.points.size()) + "\" NumberOfVerts=\"" +
         std::to_string(network.corners.size()) + "\" NumberOfLines=\"" +
         std::to_string(network.curves.size()) +
         "\" NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n<PointData>\n";
  {
    DataArray angle(out, "Float64", "angle", 1);
    for (const double a : table.angle) angle.add(degrees(a));
  }
  out += "</PointData>\n";
  append_cell_arrays(out, network);
  out += "<Points>\n";
  {
    DataArray points(out, "Float64", "Points", 3);
    for (const Vec3& p : table.points)
      for (std::size_t axis = 0; axis < 3; ++axis) points.add(p[axis]);
  }
  out += "</Points>\n";
  std::vector<std::vector<std::uint32_t>> corners;
  for (std::uint32_t k = 0; k < network.corners.size(); ++k) corners.push_back({k});
  append_cells(out, "Verts", corners);
  append_cells(out, "Lines", table.curve);
  return out + "</Piece>\n</PolyData>\n</VTKFile>\n";
}

}  // namespace spigolo
