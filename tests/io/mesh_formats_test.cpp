// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/io/mesh_formats_test.cpp - OBJ, OFF and STL by hand
#include "support.h"

namespace spigolo {
namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

TriangleMesh mesh_of(std::string_view text, FileFormat format, ReadReport* report = nullptr) {
  const TriangleMesh mesh = read_mesh(as_input(text), format, report);
  validate(mesh);
  return mesh;
}

std::string error_of(std::string_view text, FileFormat format) {
  return message_of<InputError>([&] { read_mesh(as_input(text), format); });
}

TEST(Obj, FacesInEveryNotation) {
  ReadReport report;
  const TriangleMesh mesh = mesh_of(
      "mtllib a.mtl\nv 0 0 0\nv 1 0 0 1.0\nv 1 1 0\nvt 0 0\nvn 0 0 1\nf 1 2/1 3/1/1 # c\n"
      "v 0 1 0\nf -4 \\\n-2//1 -1//-1\nf 1 2 3 4\nl 1 2 3\nusemtl b\n",
      FileFormat::obj, &report);
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}, {0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(mesh.vertices.points[1], (Vec3{1, 0, 0}));
  EXPECT_EQ(report.faces, 3u);
  EXPECT_EQ(report.lines, 1u);
}

TEST(Obj, ColoursFromBothScales) {
  for (const char* text :
       {"v 0 0 0 1 0.2 0\nv 0 0 1 0 1 0\n", "v 0 0 0 255 51 0\nv 0 0 1 0 255 0\n"}) {
    const PointCloud cloud = read_cloud(as_input(text), FileFormat::obj);
    EXPECT_EQ(cloud.find("red")->values, (std::vector<double>{255, 0})) << text;
    EXPECT_EQ(cloud.find("green")->values, (std::vector<double>{51, 255})) << text;
  }
  ReadReport report;
  const auto some = as_input("v 0 0 0 1 0 0\nv 1 1 1\n");
  EXPECT_TRUE(read_cloud(some, FileFormat::obj, &report).attributes.empty());
  EXPECT_EQ(report.warnings.size(), 1u);
}

TEST(Obj, DamageNamesTheLine) {
  EXPECT_TRUE(has(error_of("v 0 0\n", FileFormat::obj), "fixture, line 1: a vertex has 2 numbers"));
  EXPECT_TRUE(has(error_of("v 0 0 a\n", FileFormat::obj), "line 1: 'a' is not a number"));
  EXPECT_TRUE(has(error_of("v 0 0 0\nf 1 2 3\n", FileFormat::obj),
                  "line 2: a face or line names vertex 3"));
  EXPECT_TRUE(has(error_of("v 0 0 0\nf 1 -2 1\n", FileFormat::obj), "line 2: '-2'"));
  EXPECT_TRUE(has(error_of("v 0 0 0\nf 0 1 1\n", FileFormat::obj), "line 2: '0'"));
  EXPECT_TRUE(has(error_of("hello\n", FileFormat::obj), "no vertex"));
}

TEST(Off, CountsOnEitherLineKeywordOrNot) {
  const std::string body =
      "\n0 0 0\n# c\n1 0 0\n1 1 0\n0 1 0\n\n4 0 1 2 3 255 0 0 # colour\n3 0 0 1\n";
  for (const char* head : {"OFF\n4 2 0", "OFF 4 2 0", "4 2", "# c\n\nOFF # c\n4 2 5"}) {
    ReadReport report;
    const TriangleMesh mesh = mesh_of(head + body, FileFormat::off, &report);
    EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}})) << head;
    EXPECT_EQ(report.warnings.size(), 1u);
  }
}

TEST(Off, ColoursAndNormals) {
  const PointCloud whole = mesh_of("COFF\n1 0 0\n1 2 3 255 0 1 128\n", FileFormat::off).vertices;
  EXPECT_EQ(whole.find("red")->values[0], 255);
  EXPECT_EQ(whole.find("blue")->values[0], 1);
  EXPECT_EQ(whole.find("alpha")->values[0], 128);
  const PointCloud share =
      mesh_of("CNOFF\n1 0 0\n1 2 3 0 0 1 1.0 0.0 0.2\n", FileFormat::off).vertices;
  EXPECT_EQ(share.find("nz")->values[0], 1);
  EXPECT_EQ(share.find("blue")->values[0], 51);
}

TEST(Off, DamageNamesTheLine) {
  EXPECT_TRUE(has(error_of("OFF\n2 0 0\n0 0 0\n", FileFormat::off), "line 2: the header claims 2"));
  EXPECT_TRUE(
      has(error_of("OFF\n2 0 0\n0 0 0000000\n", FileFormat::off), "line 3: the file is cut"));
  EXPECT_TRUE(has(error_of("OFF\n1 0 0\n0 0\n#########\n", FileFormat::off),
                  "line 3: the line has too few"));
  EXPECT_TRUE(
      has(error_of("OFF\n1 1 0\n0 0 0\n3 0 0 1\n", FileFormat::off), "line 4: '1' names no"));
  EXPECT_TRUE(has(error_of("OFF BINARY\n", FileFormat::off), "binary OFF"));
  EXPECT_TRUE(has(error_of("4OFF\n1 0 0\n", FileFormat::off), "line 1: '4OFF'"));
  EXPECT_TRUE(has(error_of("OFF\n-1 0 0\n", FileFormat::off), "line 2"));
}

std::string binary_facet(float x) {
  return little(0.f, 0.f, 1.f, x, 0.f, 0.f, x + 1, 0.f, 0.f, x, 1.f, -0.f, std::uint16_t{0});
}

TEST(Stl, EqualCoordinatesAreWelded) {
  const std::string text = std::string(80, ' ') + little(std::uint32_t{3}) + binary_facet(0) +
                           binary_facet(0) + binary_facet(1);
  const TriangleMesh mesh = mesh_of(text, FileFormat::stl);
  EXPECT_EQ(mesh.vertices.points,
            (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}, {1, 1, 0}}));
  EXPECT_EQ(mesh.triangles, (Triangles{{0, 1, 2}, {0, 1, 2}, {1, 3, 4}}));
}

TEST(Stl, BinaryMayBeginWithSolid) {
  std::string head = "solid but binary";
  head.resize(80, ' ');
  ReadReport report;
  const std::string text = head + little(std::uint32_t{1}) + binary_facet(0);
  EXPECT_EQ(mesh_of(text, FileFormat::stl, &report).triangles.size(), 1u);
  EXPECT_EQ(report.encoding, "binary_little_endian");
}

TEST(Stl, AsciiOfSeveralSolidsInAnyCase) {
  const std::string facet =
      "FACET NORMAL 0 0 1\n OUTER LOOP\n  VERTEX 0 0 0\n  vertex 1 0 0\n"
      "  vertex 0 1e0 0\n ENDLOOP\nENDFACET\n";
  ReadReport report;
  const std::string text = "  solid a\n" + facet + "endsolid a\nsolid\n" + facet + "endsolid\n";
  EXPECT_EQ(mesh_of(text, FileFormat::stl, &report).triangles.size(), 2u);
  EXPECT_EQ(report.points, 3u);
  EXPECT_EQ(report.encoding, "ascii");
}

TEST(Stl, DamageNamesThePlace) {
  const std::string head = std::string(80, ' ') + little(std::uint32_t{2});
  EXPECT_TRUE(
      has(error_of(head + binary_facet(0), FileFormat::stl), "byte 134: the header claims 2"));
  EXPECT_TRUE(has(error_of("solid\nfacet\n", FileFormat::stl), "line 2: 'endsolid' is missing"));
  EXPECT_TRUE(has(error_of("solid\nvertex 1 2\n", FileFormat::stl), "line 2: a vertex is"));
  EXPECT_TRUE(has(error_of("solid\nfacet\nvertex 1 2 3\nendfacet\n", FileFormat::stl), "line 4"));
  EXPECT_TRUE(has(error_of("short", FileFormat::stl), "neither ascii nor binary"));
}

}  // namespace
}  // namespace spigolo
