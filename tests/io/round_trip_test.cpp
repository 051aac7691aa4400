// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/io/round_trip_test.cpp - what is written comes back, to the last bit
#include "support.h"

namespace spigolo {
namespace {

PointCloud round_trip(const PointCloud& cloud, const char* name, const WriteOptions& options = {},
                      ReadReport* report = nullptr) {
  const TempFolder folder;
  write_cloud(folder / name, cloud, options);
  EXPECT_EQ(folder.count(), 1u);
  const PointCloud back = read_cloud(folder / name, report);
  validate(back);
  return back;
}

TEST(RoundTrip, BinaryFormatsKeepEveryTypeToTheLastBit) {
  const PointCloud cloud = random_cloud(5000, 1);
  expect_same(cloud, round_trip(cloud, "a.ply"));
  expect_same(cloud, round_trip(cloud, "a.pcd"));
  WriteOptions compressed;
  compressed.compressed = true;
  ReadReport report;
  expect_same(cloud, round_trip(cloud, "a.pcd", compressed, &report));
  EXPECT_EQ(report.encoding, "binary_compressed");
}

TEST(RoundTrip, AsciiFormatsKeepEveryTypeToTheLastBit) {
  const PointCloud cloud = random_cloud(2000, 2);
  WriteOptions ascii;
  ascii.ascii = true;
  ReadReport report;
  expect_same(cloud, round_trip(cloud, "a.ply", ascii, &report));
  EXPECT_EQ(report.encoding, "ascii");
  expect_same(cloud, round_trip(cloud, "a.pcd", ascii, &report));
  EXPECT_EQ(report.encoding, "ascii");
}

TEST(RoundTrip, TablesKeepNamesAndValues) {
  const PointCloud cloud = random_cloud(2000, 3);
  for (const char* name : {"a.xyz", "a.txt", "a.csv"})
    expect_same(cloud, round_trip(cloud, name), false);
}

TEST(RoundTrip, TextKeepsPositionsInEveryFormat) {
  PointCloud cloud = random_cloud(2000, 4);
  cloud.attributes.clear();
  for (const char* name : {"a.xyz", "a.csv", "a.pts", "a.obj", "a.off"})
    expect_same(cloud, round_trip(cloud, name));
}

TEST(RoundTrip, SpecialValues) {
  PointCloud cloud;
  cloud.points = {{0.0, -0.0, 5e-324},
                  {infinity, -infinity, not_a_number},
                  {1.7976931348623157e308, 1e22, 123456789012345680.0},
                  {0.1, 100000, 1e-7}};
  for (const char* name : {"a.ply", "a.xyz", "a.csv", "a.pts", "a.obj", "a.off", "a.pcd"})
    expect_same(cloud, round_trip(cloud, name));
}

TEST(RoundTrip, SurveyCoordinatesInEveryFormat) {
  const PointCloud cloud = survey_cloud(1000, 5);
  for (const char* name : {"a.ply", "a.xyz", "a.csv", "a.pts", "a.obj", "a.off", "a.pcd", "a.las"})
    expect_same(cloud, round_trip(cloud, name));
}

TEST(RoundTrip, ColoursInEveryFormatThatHasThem) {
  PointCloud cloud = survey_cloud(300, 6);
  Random random(7);
  for (const char* name : {"red", "green", "blue"}) {
    std::vector<double> values(cloud.size());
    for (double& v : values) v = static_cast<double>(random.below(256));
    cloud.set(name, ScalarType::uint8, values);
  }
  for (const char* name : {"a.ply", "a.xyz", "a.csv", "a.pts", "a.obj", "a.pcd"})
    expect_same(cloud, round_trip(cloud, name));
  PointCloud off = round_trip(cloud, "a.off");
  off.attributes.pop_back();  // COFF wants an alpha
  expect_same(cloud, off);
}

TEST(RoundTrip, WhatDoesNotFitIsReported) {
  const TempFolder folder;
  const PointCloud cloud = random_cloud(3, 8);
  EXPECT_EQ(write_cloud(folder / "a.off", cloud).dropped.size(), 8u);
  EXPECT_EQ(write_cloud(folder / "a.pts", cloud).dropped.size(), 8u);
  EXPECT_TRUE(write_cloud(folder / "a.csv", cloud).dropped.empty());
}

TEST(RoundTrip, EmptyCloudsWhereTheFormatCanSaySo) {
  for (const char* name : {"a.ply", "a.off", "a.pcd", "a.las"})
    EXPECT_EQ(round_trip({}, name).size(), 0u) << name;
}

TEST(RoundTrip, MeshesKeepVerticesAndTriangles) {
  TriangleMesh mesh;
  mesh.vertices = survey_cloud(3, 9);
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {3, 1, 0}};
  const TempFolder folder;
  WriteOptions ascii;
  ascii.ascii = true;
  for (const char* name : {"a.ply", "a.obj", "a.off", "a.stl"})
    for (const WriteOptions& options : {WriteOptions{}, ascii}) {
      const bool floats = std::string(name) == "a.stl" && !options.ascii;
      if (floats)
        for (Vec3& p : mesh.vertices.points) p = {std::floor(p.x), std::floor(p.y), p.x - p.y};
      if (floats)
        for (Vec3& p : mesh.vertices.points) p.z = static_cast<double>(static_cast<float>(p.z));
      EXPECT_EQ(write_mesh(folder / name, mesh, options).rounding, 0);
      const TriangleMesh back = read_mesh(folder / name);
      expect_same(mesh.vertices, back.vertices);
      EXPECT_EQ(mesh.triangles, back.triangles) << name;
      if (floats) mesh.vertices = survey_cloud(3, 9);
    }
}

TEST(RoundTrip, BinaryStlTellsItsRounding) {
  TriangleMesh mesh;
  mesh.vertices.points = {{6123456.789, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  mesh.triangles = {{0, 1, 2}};
  const TempFolder folder;
  EXPECT_NEAR(write_mesh(folder / "a.stl", mesh).rounding, 0.211, 1e-9);
}

}  // namespace
}  // namespace spigolo
