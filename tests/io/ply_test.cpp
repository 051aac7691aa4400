// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/io/ply_test.cpp - odd but legal PLY files, and damaged ones
#include "support.h"

#include "spigolo/io/ply_reader.h"
#include "spigolo/io/ply_writer.h"

namespace spigolo {
namespace {

PointCloud cloud_of(std::string_view text, ReadReport* report = nullptr) {
  const PointCloud cloud = read_cloud(as_input(text), FileFormat::ply, report);
  validate(cloud);
  return cloud;
}

std::string error_of(std::string_view text) {
  return message_of<InputError>([&] { read_cloud(as_input(text), FileFormat::ply); });
}

constexpr const char* xyz_properties = "property float x\nproperty float y\nproperty float z\n";

TEST(Ply, EveryTypeUnderBothNamesInBothOrders) {
  const char* names[2][8] = {
      {"char", "uchar", "short", "ushort", "int", "uint", "float", "double"},
      {"int8", "uint8", "int16", "uint16", "int32", "uint32", "float32", "float64"}};
  for (const auto& set : names)
    for (const ByteOrder order : {ByteOrder::little, ByteOrder::big}) {
      std::string text = std::string("ply\nformat binary_") +
                         (order == ByteOrder::big ? "big" : "little") +
                         "_endian 1.0\nelement vertex 1\n";
      for (int t = 0; t < 8; ++t)
        text += std::string("property ") + set[t] + " " + std::string(1, "abcdexyz"[t]) + "\n";
      text +=
          "end_header\n" + packed(order, std::int8_t{-7}, std::uint8_t{200}, std::int16_t{-30000},
                                  std::uint16_t{60000}, std::int32_t{-2000000000},
                                  std::uint32_t{4000000000u}, 1.5f, 6123456.789);
      const PointCloud cloud = cloud_of(text);
      EXPECT_EQ(cloud.points.at(0), (Vec3{4000000000.0, 1.5, 6123456.789}));
      EXPECT_EQ(cloud.find("a")->values[0], -7);
      EXPECT_EQ(cloud.find("b")->values[0], 200);
      EXPECT_EQ(cloud.find("c")->values[0], -30000);
      EXPECT_EQ(cloud.find("d")->values[0], 60000);
      EXPECT_EQ(cloud.find("e")->values[0], -2000000000);
      EXPECT_EQ(cloud.find("e")->type, ScalarType::int32);
    }
}

TEST(Ply, ABodyThatBeginsWithALineFeedKeepsIt) {
  const std::string head = std::string("format binary_little_endian 1.0\nelement vertex 1\n") +
                           "property uchar x\nproperty uchar y\nproperty uchar z\nend_header\n";
  EXPECT_EQ(cloud_of("ply\n" + head + "\n\r\n").points.at(0), (Vec3{10, 13, 10}));
  std::string dos = "ply\n" + head;
  for (std::size_t at = 0; (at = dos.find('\n', at)) != dos.npos; at += 2)
    dos.replace(at, 1, "\r\n");
  EXPECT_EQ(cloud_of(dos + "\n\r\n").points.at(0), (Vec3{10, 13, 10}));
  std::string mac = "ply\n" + head;
  for (char& c : mac) c = c == '\n' ? '\r' : c;
  EXPECT_EQ(cloud_of(mac + "\n\r\n").points.at(0), (Vec3{10, 13, 10}));
}

TEST(Ply, ListsOfVerticesAreSteppedOverAndOtherElementsToo) {
  const std::string text =
      std::string(
          "ply\nformat binary_little_endian 1.0\nelement camera 1\nproperty list uchar "
          "short pose\nproperty float f\nelement vertex 2\nproperty float x\nproperty list "
          "ushort double w\nproperty float y\nproperty float z\nelement edge 1\nproperty "
          "int vertex1\nend_header\n") +
      little(std::uint8_t{3}, std::int16_t{1}, std::int16_t{1}, std::int16_t{1}, 9.f) +
      little(1.f, std::uint16_t{2}, 8.0, 8.0, 2.f, 3.f) + little(4.f, std::uint16_t{0}, 5.f, 6.f) +
      little(std::int32_t{0});
  ReadReport report;
  const PointCloud cloud = cloud_of(text, &report);
  EXPECT_EQ(cloud.points, (std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_EQ(report.skipped, (std::vector<std::string>{"element camera", "list property w of vertex",
                                                      "element edge"}));
  EXPECT_TRUE(report.warnings.empty());
}

TEST(Ply, AsciiLinesMayWrapAndBlanksMayVary) {
  const std::string text = std::string("ply\nformat ascii 1.0\ncomment\nobj_info made by hand\n") +
                           "element vertex 2\n" + xyz_properties +
                           "end_header\n1\n2 3 4\t5\r\n\n+6";
  EXPECT_EQ(cloud_of(text).points, (std::vector<Vec3>{{1, 2, 3}, {4, 5, 6}}));
}

TEST(Ply, RepeatedNamesAreMadeUnique) {
  const std::string text =
      std::string("ply\nformat ascii 1.0\nelement vertex 1\n") + xyz_properties +
      "property int a\nproperty int a\nproperty int x\nend_header\n1 2 3 4 5 6";
  const PointCloud cloud = cloud_of(text);
  EXPECT_EQ(cloud.points.at(0), (Vec3{1, 2, 3}));
  EXPECT_EQ(cloud.find("a")->values[0], 4);
  EXPECT_EQ(cloud.find("a_2")->values[0], 5);
  EXPECT_EQ(cloud.find("x_2")->values[0], 6);
}

TEST(Ply, PolygonsBecomeFansAndDegenerateOnesAreCounted) {
  const std::string text = std::string(
                               "ply\nformat ascii 1.0\nelement face 3\nproperty list uchar "
                               "int vertex_index\nproperty int tag\nelement vertex 5\n") +
                           xyz_properties + "end_header\n5 0 1 2 3 4 7\n3 1 1 2 7\n2 0 1 7\n" +
                           "0 0 0 1 0 0 2 1 0 1 2 0 0 1 0";
  ReadReport report;
  const TriangleMesh mesh = read_mesh(as_input(text), FileFormat::ply, &report);
  EXPECT_EQ(mesh.triangles,
            (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
  EXPECT_EQ(report.faces, 3u);
  ASSERT_EQ(report.warnings.size(), 1u);
  EXPECT_TRUE(has(report.warnings[0], "2 "));
}

TEST(Ply, FurtherElementsAreWritten) {
  const TempFolder folder;
  PointCloud cloud;
  cloud.points = {{0, 0, 0}, {1, 0, 0}};
  const PlyElement edges{"edge",
                         {{"vertex1", ScalarType::int32, {0}},
                          {"vertex2", ScalarType::int32, {1}},
                          {"scalar_curve", ScalarType::float32, {0.5}}}};
  AtomicFile out(folder / "a.ply");
  write_ply(out, cloud, {}, std::span(&edges, 1), {true, {"two\nlines"}});
  out.commit();
  EXPECT_EQ(read_file(folder / "a.ply"),
            "ply\nformat ascii 1.0\ncomment two lines\nelement vertex 2\nproperty double x\n"
            "property double y\nproperty double z\nelement edge 1\nproperty int vertex1\nproperty "
            "int vertex2\nproperty float scalar_curve\nend_header\n0 0 0\n1 0 0\n0 1 0.5\n");
}

TEST(Ply, DamagedHeadersNameTheLine) {
  EXPECT_TRUE(has(error_of("solid"), "fixture, header: does not begin with the line 'ply'"));
  EXPECT_TRUE(has(error_of("ply\nformat binary 1.0\n"), "header line 2: unknown format 'binary'"));
  EXPECT_TRUE(has(error_of("ply\nformat ascii 1.0\nelement vertex -1\n"), "header line 3"));
  EXPECT_TRUE(has(error_of("ply\nproperty float x\n"), "before the first element"));
  EXPECT_TRUE(has(error_of("ply\nelement vertex 1\nproperty real x\n"), "unknown type 'real'"));
  EXPECT_TRUE(has(error_of("ply\nelement a 1\nproperty list float int x\n"), "cannot be a float"));
  EXPECT_TRUE(has(error_of("ply\nformat ascii 1.0\n"), "'end_header' is missing"));
  EXPECT_TRUE(has(error_of("ply\nend_header\n"), "'format ...' is missing"));
  EXPECT_TRUE(has(error_of("ply\nformat ascii 1.0\nend_header\n"), "no element 'vertex'"));
  EXPECT_TRUE(
      has(error_of("ply\nformat ascii 1.0\nelement vertex 0\nend_header\n"), "property 'x'"));
}

TEST(Ply, DamagedBodiesNameThePlace) {
  const std::string head =
      std::string("ply\nformat ascii 1.0\nelement vertex 2\n") + xyz_properties + "end_header\n";
  EXPECT_TRUE(has(error_of(head + "1 2 3\n4 x 6\n"), "line 9: 'x' is not a number"));
  EXPECT_TRUE(has(error_of(head + "1 2 3\n4 5.....\n"), "line 9: "));
  EXPECT_TRUE(has(error_of(head + "1 2 3"), "room for at most 1"));
  EXPECT_TRUE(has(error_of(head + "1 2 30 4     \n"), "cut off"));
}

TEST(Ply, FacesOfVerticesThatAreNotThere) {
  const std::string head = std::string("ply\nformat ascii 1.0\nelement vertex 1\n") +
                           xyz_properties +
                           "element face 1\nproperty list char int vertex_indices\nend_header\n"
                           "0 0 0\n";
  const auto mesh_error = [&](const char* face) {
    return message_of<InputError>([&] { read_mesh(as_input(head + face), FileFormat::ply); });
  };
  EXPECT_TRUE(has(mesh_error("3 0 0 1\n"), "names vertex 1 of 1"));
  EXPECT_TRUE(has(mesh_error("3 0 0 -1\n"), "line 11"));
  EXPECT_TRUE(has(mesh_error("-3 0 0 0\n"), "list length"));
}

}  // namespace
}  // namespace spigolo
