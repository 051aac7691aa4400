// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// io: feature curves read back from DXF, OBJ, PLY and VTP by readers that share no code with the
// writers
#include "spigolo/io/curve_writers.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <set>
#include <sstream>

#include "io/support.h"
#include "spigolo/core/error.h"
#include "spigolo/io/curve_tables.h"

namespace spigolo::test {
namespace {

FeatureCurve line(const Vec3& a, const Vec3& b, std::int32_t ca, std::int32_t cb) {
  FeatureCurve curve;
  curve.shape = CurveShape::line;
  curve.corner = {ca, cb};
  curve.points = {a, (a + b) / 2, b};
  curve.angle = {1, 1.5, 1};
  curve.convex = 1;
  return curve;
}

// About a tilted axis, from angle 0 through `sweep`.
FeatureCurve round_curve(bool closed, double sweep) {
  FeatureCurve curve;
  curve.shape = closed ? CurveShape::circle : CurveShape::arc;
  curve.closed = closed;
  curve.center = {3, -1, 2};
  curve.axis = normalized(Vec3{1, 2, -2});
  curve.radius = 4;
  const Vec3 x = any_perpendicular(curve.axis), y = cross(curve.axis, x);
  for (int i = 0; i < 24 + (closed ? 0 : 1); ++i) {
    const double t = sweep * i / 24;
    curve.points.push_back(curve.center + (x * std::cos(t) + y * std::sin(t)) * curve.radius);
    curve.angle.push_back(0.7);
  }
  curve.convex = -1;
  return curve;
}

FeatureCurve bent() {
  FeatureCurve curve;
  curve.spline = {3, {0, 0, 0, 0, 2, 2, 2, 2}, {{0, 0, 9}, {1, 2, 9}, {2, -2, 9}, {3, 0, 9}}};
  curve.points = {{0, 0, 9}, {1.5, 0, 9}, {3, 0, 9}};
  curve.angle = {0.5, 0.5, 0.5};
  return curve;
}

FeatureCurves network() {
  FeatureCurves n;
  n.corners = {{{0, 0, 0}, 2}, {{1, 0, 0}, 2}};
  n.curves = {line({0, 0, 0}, {1, 0, 0}, 0, 1), line({1, 0, 0}, {0, 0, 0}, 1, 0),
              round_curve(true, 2 * pi), round_curve(false, 4), bent()};
  validate(n);
  return n;
}

// A DXF as its entities: each a list of (code, value).
using Tags = std::vector<std::pair<int, std::string>>;
std::vector<Tags> entities_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<Tags> entities;
  std::string code, value, section;
  bool naming = false;
  while (std::getline(in, code) && std::getline(in, value)) {
    const int c = std::atoi(code.c_str());
    if (c == 0) naming = value == "SECTION";
    if (c == 2 && naming) section = value, naming = false;
    if (c == 0 && value == "ENDSEC") section.clear();
    if (section != "ENTITIES") continue;
    if (c == 0) entities.push_back({});
    if (!entities.empty()) entities.back().push_back({c, value});
  }
  return entities;
}

double real(const Tags& tags, int code) {
  for (const auto& [c, value] : tags)
    if (c == code) return std::strtod(value.c_str(), nullptr);
  ADD_FAILURE() << "no group " << code;
  return 0;
}
Vec3 point(const Tags& tags, int code) {
  return {real(tags, code), real(tags, code + 10), real(tags, code + 20)};
}
std::vector<double> reals(const Tags& tags, int code) {
  std::vector<double> all;
  for (const auto& [c, value] : tags)
    if (c == code) all.push_back(std::strtod(value.c_str(), nullptr));
  return all;
}
std::string text(const Tags& tags, int code) {
  for (const auto& [c, value] : tags)
    if (c == code) return value;
  return "";
}
std::vector<Tags> of_type(const std::vector<Tags>& entities, const std::string& type) {
  std::vector<Tags> found;
  for (const Tags& tags : entities)
    if (tags.front().second == type) found.push_back(tags);
  return found;
}

TEST(Dxf, holdsEveryCurveAsWhatItIs) {
  const auto entities = entities_of(dxf_text(network(), {}));
  EXPECT_EQ(of_type(entities, "LINE").size(), 2u);
  EXPECT_EQ(of_type(entities, "CIRCLE").size(), 1u);
  EXPECT_EQ(of_type(entities, "ARC").size(), 1u);
  EXPECT_EQ(of_type(entities, "SPLINE").size(), 1u);
  EXPECT_EQ(of_type(entities, "POINT").size(), 2u);
  for (const Tags& tags : of_type(entities, "POINT")) EXPECT_EQ(text(tags, 8), "CORNER");
  for (const Tags& tags : of_type(entities, "LINE")) EXPECT_EQ(text(tags, 8), "EDGE_CONVEX");
  EXPECT_EQ(text(of_type(entities, "ARC")[0], 8), "EDGE_CONCAVE");
  EXPECT_EQ(text(of_type(entities, "SPLINE")[0], 8), "EDGE_UNKNOWN");
  EXPECT_EQ(point(of_type(entities, "LINE")[0], 11), (Vec3{1, 0, 0}));
}

TEST(Dxf, bordersHaveALayerOfTheirOwn) {
  FeatureCurves n = network();
  n.curves[0].kind = CurveKind::border;
  n.curves[0].convex = 0;
  const auto lines = of_type(entities_of(dxf_text(n, {})), "LINE");
  EXPECT_EQ(text(lines[0], 8), "BORDER");
  EXPECT_EQ(text(lines[1], 8), "EDGE_CONVEX");
}

// The ends of an arc, computed from its group codes as the DXF reference says.
TEST(Dxf, arcsEndWhereTheCurveDoes) {
  const FeatureCurve arc = round_curve(false, 4);
  const auto entities = entities_of(dxf_text({{}, {arc}}, {}));
  const Tags tags = of_type(entities, "ARC")[0];
  const Vec3 z = point(tags, 210);
  EXPECT_LT(distance(z, arc.axis), 1e-12);
  const bool near_z = std::abs(z.x) < 1.0 / 64 && std::abs(z.y) < 1.0 / 64;
  const Vec3 x = normalized(cross(near_z ? Vec3{0, 1, 0} : Vec3{0, 0, 1}, z)), y = cross(z, x);
  const Vec3 c = point(tags, 10);
  const double r = real(tags, 40);
  const auto at = [&](double angle) {
    const double a = radians(angle);
    return x * (c.x + r * std::cos(a)) + y * (c.y + r * std::sin(a)) + z * c.z;
  };
  EXPECT_LT(distance(at(real(tags, 50)), arc.points.front()), 1e-9);
  EXPECT_LT(distance(at(real(tags, 51)), arc.points.back()), 1e-9);
  double sweep = real(tags, 51) - real(tags, 50);
  if (sweep < 0) sweep += 360;
  EXPECT_NEAR(sweep, degrees(4), 1e-9);
}

TEST(Dxf, splinesKeepKnotsAndPoles) {
  const auto entities = entities_of(dxf_text(network(), {}));
  const Tags tags = of_type(entities, "SPLINE")[0];
  EXPECT_EQ(reals(tags, 40), (std::vector<double>{0, 0, 0, 0, 2, 2, 2, 2}));
  EXPECT_EQ(reals(tags, 10), (std::vector<double>{0, 1, 2, 3}));
  EXPECT_EQ(reals(tags, 20), (std::vector<double>{0, 2, -2, 0}));
  EXPECT_EQ(real(tags, 72), 8);
  EXPECT_EQ(real(tags, 73), 4);
}

TEST(Dxf, handlesAreUniqueAndPointersLead) {
  std::istringstream in(dxf_text(network(), {LengthUnit::metre, 0}));
  std::set<std::string> handles;
  std::vector<std::string> owners;
  std::string code, value, last, units;
  std::size_t sections = 0;
  while (std::getline(in, code) && std::getline(in, value)) {
    const int c = std::atoi(code.c_str());
    sections += c == 0 && value == "SECTION";
    if (c == 5 && last != "$HANDSEED") {
      EXPECT_TRUE(handles.insert(value).second) << value;
    }
    if (c == 330 && value != "0") owners.push_back(value);
    if (last == "$INSUNITS" && c == 70) units = value, last.clear();
    if (c == 9 || c == 0) last = value;
  }
  EXPECT_EQ(value, "EOF");
  EXPECT_EQ(units, "6");
  EXPECT_EQ(sections, 6u);
  for (const std::string& owner : owners) EXPECT_TRUE(handles.count(owner)) << owner;
}

TEST(Dxf, anEmptyNetworkIsAWholeDrawing) {
  const std::string dxf = dxf_text({}, {});
  EXPECT_TRUE(entities_of(dxf).empty());
  EXPECT_NE(dxf.find("OBJECTS"), std::string::npos);
  EXPECT_EQ(dxf.substr(dxf.size() - 6), "0\nEOF\n");
}

// Well-formed: every element that opens closes, in order; numbers as many as announced.
TEST(Vtp, isWellFormedAndHoldsWhatItSays) {
  const std::string xml = vtp_text(network());
  std::vector<std::string> open;
  std::map<std::string, std::vector<double>> arrays;
  std::string name;
  for (std::size_t at = xml.find('<'); at != std::string::npos;) {
    const std::size_t end = xml.find('>', at), next = xml.find('<', end);
    const std::string tag = xml.substr(at + 1, end - at - 1);
    if (tag[0] == '/') {
      ASSERT_FALSE(open.empty());
      EXPECT_EQ(open.back(), tag.substr(1));
      open.pop_back();
    } else if (tag[0] != '?') {
      open.push_back(tag.substr(0, tag.find(' ')));
      if (open.back() == "DataArray") {
        const std::size_t from = tag.find("Name=\"") + 6;
        name = open[open.size() - 2] + "." + tag.substr(from, tag.find('"', from) - from);
        std::istringstream numbers(xml.substr(end + 1, next - end - 1));
        for (double v; numbers >> v;) arrays[name].push_back(v);
      }
    }
    at = next;
  }
  EXPECT_TRUE(open.empty());
  EXPECT_EQ(arrays["Verts.connectivity"], (std::vector<double>{0, 1}));
  EXPECT_EQ(arrays["Lines.offsets"].size(), 5u);
  EXPECT_EQ(arrays["Lines.offsets"].back(),
            static_cast<double>(arrays["Lines.connectivity"].size()));
  EXPECT_EQ(arrays["Points.Points"].size(), 3 * arrays["PointData.angle"].size());
  EXPECT_EQ(arrays["CellData.curve"].size(), 7u);
}

TEST(CurveTables, cornersAreSharedVertices) {
  const CurveVertices table = shared_vertices(network());
  EXPECT_EQ(table.curve[0].front(), 0u);
  EXPECT_EQ(table.curve[0].back(), 1u);
  EXPECT_EQ(table.curve[1].front(), 1u);
  EXPECT_EQ(table.curve[2].front(), table.curve[2].back());
  EXPECT_EQ(table.points.size(), 2u + 1 + 1 + 24 + 25 + 3);
}

// Rational quadratic pieces lie on the circle itself.
TEST(CurveTables, roundSplinesAreExact) {
  for (const FeatureCurve& curve : {round_curve(true, 2 * pi), round_curve(false, 4)}) {
    const RationalSpline s = rational_spline(curve);
    ASSERT_EQ(s.knots.size(), s.poles.size() + 3);
    for (std::size_t piece = 0; piece + 2 < s.poles.size(); piece += 2)
      for (double t = 0; t <= 1; t += 0.125) {
        const std::array<double, 3> b = {(1 - t) * (1 - t), 2 * t * (1 - t), t * t};
        Vec3 sum;
        double weight = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          sum += s.poles[piece + k] * (b[k] * s.weights[piece + k]);
          weight += b[k] * s.weights[piece + k];
        }
        EXPECT_NEAR(distance(sum / weight, curve.center), curve.radius, 1e-12);
      }
    EXPECT_LT(distance(s.poles.back(), curve.closed ? curve.points.front() : curve.points.back()),
              1e-12);
  }
}

TEST(CurveFiles, linesComeBackFromObjAndPly) {
  const FeatureCurves n = network();
  const TempFolder folder;
  for (const char* file : {"a.obj", "a.ply"}) {
    AtomicFile out(folder / file);
    write_curves(out, curve_format(file), n);
    out.commit();
    const FileBytes bytes(folder / file);
    FileLines lines;
    const std::vector<Vec3> points =
        read_mesh(bytes.view(), file_format(file, FileUse::read_mesh), nullptr, &lines)
            .vertices.points;
    ASSERT_EQ(lines.size(), n.curves.size()) << file;
    for (std::size_t c = 0; c < n.curves.size(); ++c) {
      const std::size_t extra = n.curves[c].closed ? 1 : 0;
      ASSERT_EQ(lines[c].size(), n.curves[c].points.size() + extra);
      for (std::size_t i = 0; i < n.curves[c].points.size(); ++i)
        EXPECT_EQ(points[lines[c][i]], n.curves[c].points[i]);
    }
  }
}

TEST(CurveFiles, damagedLinesAreRefused) {
  const std::string obj = "v 0 0 0\nv 1 0 0\nl 1 3\n";
  const InputBytes bytes = as_input(obj);
  FileLines lines;
  EXPECT_THROW(read_mesh(bytes, FileFormat::obj, nullptr, &lines), InputError);
}

TEST(CurveFiles, namesAndUnitsAreChecked) {
  EXPECT_EQ(curve_format("A.DXF"), CurveFormat::dxf);
  EXPECT_THROW(curve_format("a.dwg"), UsageError);
  EXPECT_EQ(length_unit("mm"), LengthUnit::millimetre);
  EXPECT_THROW(length_unit("yard"), UsageError);
}

}  // namespace
}  // namespace spigolo::test
