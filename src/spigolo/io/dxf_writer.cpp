// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/dxf_writer.cpp - AutoCAD 2000 DXF (AC1015), the oldest that knows splines and units
//
// Group codes after Autodesk's public DXF reference. Circles and arcs stand in the coordinate
// system that the arbitrary axis algorithm gives to their extrusion direction.
#include <array>
#include <cmath>
#include <string_view>

#include "spigolo/io/curve_tables.h"
#include "spigolo/io/curve_writers.h"

namespace spigolo {
namespace {

struct LayerEntry {
  const char* name;
  int color;  // AutoCAD colour index
};
constexpr std::array<LayerEntry, 6> layers = {{{"0", 7},
                                               {"EDGE_CONVEX", 1},
                                               {"EDGE_CONCAVE", 5},
                                               {"EDGE_UNKNOWN", 30},
                                               {"BORDER", 3},
                                               {"CORNER", 6}}};

const char* layer_of(const FeatureCurve& curve) {
  if (curve.kind == CurveKind::border) return "BORDER";
  return curve.convex > 0 ? "EDGE_CONVEX" : curve.convex < 0 ? "EDGE_CONCAVE" : "EDGE_UNKNOWN";
}

int insertion_units(LengthUnit unit) {
  constexpr std::array<int, 6> codes = {0, 4, 5, 6, 1, 2};
  return codes[static_cast<std::size_t>(unit)];
}

// Fixed handles of the tables and records that every drawing has; entities come after them.
enum Handle : std::uint32_t {
  block_records = 0x1,
  layer_table = 0x2,
  style_table = 0x3,
  linetype_table = 0x5,
  view_table = 0x6,
  ucs_table = 0x7,
  viewport_table = 0x8,
  application_table = 0x9,
  dimension_table = 0xA,
  root_dictionary = 0xC,
  group_dictionary = 0xD,
  model_record = 0x1F,
  paper_record = 0x1B,
  first_layer = 0x40,
  first_entity = 0x100
};

class DxfText {
 public:
  void tag(int code, std::string_view value) {
    text_ += std::to_string(code);
    text_ += '\n';
    text_ += value;
    text_ += '\n';
  }
  void tag(int code, int value) { tag(code, std::to_string(value)); }
  void real(int code, double value) {
    text_ += std::to_string(code);
    text_ += '\n';
    append_double(text_, value);
    text_ += '\n';
  }
  void point(int code, const Vec3& p) {
    for (int axis = 0; axis < 3; ++axis) real(code + 10 * axis, p[static_cast<std::size_t>(axis)]);
  }
  void handle(int code, std::uint32_t value) {
    std::string digits;
    for (; value > 0 || digits.empty(); value >>= 4) digits += "0123456789ABCDEF"[value & 15];
    tag(code, std::string(digits.rbegin(), digits.rend()));
  }
  void begin_section(std::string_view name) {
    tag(0, "SECTION");
    tag(2, name);
  }
  void end_section() { tag(0, "ENDSEC"); }

  void begin_table(std::string_view name, std::uint32_t own, int entries) {
    tag(0, "TABLE");
    tag(2, name);
    handle(5, own);
    handle(330, 0);
    tag(100, "AcDbSymbolTable");
    tag(70, entries);
  }
  void end_table() { tag(0, "ENDTAB"); }
  void record(std::string_view type, std::uint32_t own, std::uint32_t table,
              std::string_view subclass, std::string_view name) {
    tag(0, type);
    handle(5, own);
    handle(330, table);
    tag(100, "AcDbSymbolTableRecord");
    tag(100, subclass);
    tag(2, name);
  }
  void entity(std::string_view type, std::string_view layer, std::string_view subclass) {
    tag(0, type);
    handle(5, next_entity_++);
    handle(330, model_record);
    tag(100, "AcDbEntity");
    tag(8, layer);
    if (!subclass.empty()) tag(100, subclass);
  }
  std::uint32_t next_entity() const { return next_entity_; }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
  std::uint32_t next_entity_ = first_entity;
};

void write_tables(DxfText& dxf) {
  dxf.begin_section("TABLES");
  dxf.begin_table("VPORT", viewport_table, 0);
  dxf.end_table();
  dxf.begin_table("LTYPE", linetype_table, 3);
  constexpr std::array<const char*, 3> linetypes = {"ByBlock", "ByLayer", "Continuous"};
  for (std::uint32_t i = 0; i < linetypes.size(); ++i) {
    dxf.record("LTYPE", 0x14 + i, linetype_table, "AcDbLinetypeTableRecord", linetypes[i]);
    dxf.tag(70, 0), dxf.tag(3, ""), dxf.tag(72, 65), dxf.tag(73, 0), dxf.real(40, 0);
  }
  dxf.end_table();
  dxf.begin_table("LAYER", layer_table, static_cast<int>(layers.size()));
  for (std::uint32_t i = 0; i < layers.size(); ++i) {
    dxf.record("LAYER", first_layer + i, layer_table, "AcDbLayerTableRecord", layers[i].name);
    dxf.tag(70, 0), dxf.tag(62, layers[i].color), dxf.tag(6, "Continuous");
  }
  dxf.end_table();
  dxf.begin_table("STYLE", style_table, 1);
  dxf.record("STYLE", 0x11, style_table, "AcDbTextStyleTableRecord", "Standard");
  dxf.tag(70, 0), dxf.real(40, 0), dxf.real(41, 1), dxf.real(50, 0), dxf.tag(71, 0);
  dxf.real(42, 1), dxf.tag(3, "txt"), dxf.tag(4, "");
  dxf.end_table();
  dxf.begin_table("VIEW", view_table, 0);
  dxf.end_table();
  dxf.begin_table("UCS", ucs_table, 0);
  dxf.end_table();
  dxf.begin_table("APPID", application_table, 1);
  dxf.record("APPID", 0x12, application_table, "AcDbRegAppTableRecord", "ACAD");
  dxf.tag(70, 0);
  dxf.end_table();
  dxf.begin_table("DIMSTYLE", dimension_table, 0);
  dxf.tag(100, "AcDbDimStyleTable"), dxf.tag(71, 0);
  dxf.end_table();
  dxf.begin_table("BLOCK_RECORD", block_records, 2);
  dxf.record("BLOCK_RECORD", model_record, block_records, "AcDbBlockTableRecord", "*Model_Space");
  dxf.record("BLOCK_RECORD", paper_record, block_records, "AcDbBlockTableRecord", "*Paper_Space");
  dxf.end_table();
  dxf.end_section();
}

void write_block(DxfText& dxf, std::uint32_t record, std::uint32_t own, std::string_view name) {
  dxf.tag(0, "BLOCK"), dxf.handle(5, own), dxf.handle(330, record);
  dxf.tag(100, "AcDbEntity"), dxf.tag(8, "0"), dxf.tag(100, "AcDbBlockBegin");
  dxf.tag(2, name), dxf.tag(70, 0), dxf.point(10, {}), dxf.tag(3, name), dxf.tag(1, "");
  dxf.tag(0, "ENDBLK"), dxf.handle(5, own + 1), dxf.handle(330, record);
  dxf.tag(100, "AcDbEntity"), dxf.tag(8, "0"), dxf.tag(100, "AcDbBlockEnd");
}

void write_line(DxfText& dxf, const FeatureCurve& curve) {
  dxf.entity("LINE", layer_of(curve), "AcDbLine");
  dxf.point(10, curve.points.front());
  dxf.point(11, curve.points.back());
}

// The arbitrary axis algorithm: x and y of the system whose z is the extrusion direction.
std::array<Vec3, 2> arbitrary_axes(const Vec3& z) {
  const bool near_z = std::abs(z.x) < 1.0 / 64 && std::abs(z.y) < 1.0 / 64;
  const Vec3 x = normalized(cross(near_z ? Vec3{0, 1, 0} : Vec3{0, 0, 1}, z));
  return {x, normalized(cross(z, x))};
}

void write_round(DxfText& dxf, const FeatureCurve& curve) {
  const std::array<Vec3, 2> axes = arbitrary_axes(curve.axis);
  const Vec3 &x = axes[0], &y = axes[1];
  const bool circle = curve.shape == CurveShape::circle;
  dxf.entity(circle ? "CIRCLE" : "ARC", layer_of(curve), "AcDbCircle");
  dxf.point(10, {dot(curve.center, x), dot(curve.center, y), dot(curve.center, curve.axis)});
  dxf.real(40, curve.radius);
  dxf.point(210, curve.axis);
  if (circle) return;
  dxf.tag(100, "AcDbArc");
  const auto angle = [&](const Vec3& p) {
    const double a = degrees(std::atan2(dot(p - curve.center, y), dot(p - curve.center, x)));
    return a < 0 ? a + 360 : a;
  };
  dxf.real(50, angle(curve.points.front()));
  dxf.real(51, angle(curve.points.back()));
}

void write_spline(DxfText& dxf, const FeatureCurve& curve) {
  constexpr int closed_flag = 1;
  dxf.entity("SPLINE", layer_of(curve), "AcDbSpline");
  dxf.tag(70, curve.closed ? closed_flag : 0);
  dxf.tag(71, curve.spline.degree);
  dxf.tag(72, static_cast<int>(curve.spline.knots.size()));
  dxf.tag(73, static_cast<int>(curve.spline.poles.size()));
  dxf.tag(74, 0);
  dxf.real(42, 1e-9), dxf.real(43, 1e-10);
  for (const double knot : curve.spline.knots) dxf.real(40, knot);
  for (const Vec3& pole : curve.spline.poles) dxf.point(10, pole);
}

void write_polyline(DxfText& dxf, const FeatureCurve& curve) {
  constexpr int polyline_3d = 8, vertex_3d = 32;
  dxf.entity("POLYLINE", layer_of(curve), "AcDb3dPolyline");
  dxf.tag(66, 1), dxf.point(10, {}), dxf.tag(70, polyline_3d + (curve.closed ? 1 : 0));
  for (const Vec3& p : curve.points) {
    dxf.entity("VERTEX", layer_of(curve), "AcDbVertex");
    dxf.tag(100, "AcDb3dPolylineVertex"), dxf.point(10, p), dxf.tag(70, vertex_3d);
  }
  dxf.entity("SEQEND", layer_of(curve), "");
}

void write_entities(DxfText& dxf, const FeatureCurves& network) {
  dxf.begin_section("ENTITIES");
  for (const FeatureCurve& curve : network.curves) {
    if (curve.shape == CurveShape::line)
      write_line(dxf, curve);
    else if (curve.shape != CurveShape::spline)
      write_round(dxf, curve);
    else if (!curve.spline.poles.empty())
      write_spline(dxf, curve);
    else
      write_polyline(dxf, curve);
  }
  for (const FeatureCorner& corner : network.corners) {
    dxf.entity("POINT", "CORNER", "AcDbPoint");
    dxf.point(10, corner.position);
  }
  dxf.end_section();
}

void write_objects(DxfText& dxf) {
  dxf.begin_section("OBJECTS");
  dxf.tag(0, "DICTIONARY"), dxf.handle(5, root_dictionary), dxf.handle(330, 0);
  dxf.tag(100, "AcDbDictionary"), dxf.tag(281, 1);
  dxf.tag(3, "ACAD_GROUP"), dxf.handle(350, group_dictionary);
  dxf.tag(0, "DICTIONARY"), dxf.handle(5, group_dictionary), dxf.handle(330, root_dictionary);
  dxf.tag(100, "AcDbDictionary"), dxf.tag(281, 1);
  dxf.end_section();
}

}  // namespace

std::string dxf_text(const FeatureCurves& network, const CurveFileOptions& options) {
  DxfText body;
  body.begin_section("CLASSES");
  body.end_section();
  write_tables(body);
  body.begin_section("BLOCKS");
  write_block(body, model_record, 0x20, "*Model_Space");
  write_block(body, paper_record, 0x22, "*Paper_Space");
  body.end_section();
  write_entities(body, network);
  write_objects(body);

  DxfText head;
  head.begin_section("HEADER");
  head.tag(9, "$ACADVER"), head.tag(1, "AC1015");
  head.tag(9, "$HANDSEED"), head.handle(5, body.next_entity());
  head.tag(9, "$INSUNITS"), head.tag(70, insertion_units(options.unit));
  const bool imperial = options.unit == LengthUnit::inch || options.unit == LengthUnit::foot;
  head.tag(9, "$MEASUREMENT"), head.tag(70, imperial ? 0 : 1);
  Box box;
  for (const FeatureCurve& curve : network.curves)
    for (const Vec3& p : curve.points) box.add(p);
  if (!box.empty()) {
    head.tag(9, "$EXTMIN"), head.point(10, box.min);
    head.tag(9, "$EXTMAX"), head.point(10, box.max);
  }
  head.end_section();
  return head.take() + body.take() + "0\nEOF\n";
}

}  // namespace spigolo
