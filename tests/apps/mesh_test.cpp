// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo mesh: every format, its JSON, its refusals
#include <fstream>

#include "apps/program.h"
#include "spigolo/io/cloud_file.h"

namespace spigolo::test {
namespace {

class Mesh : public ProgramTest {};

TEST_F(Mesh, aCubeComesOutSharpAndWatertightInEveryFormat) {
  const std::string cube = cloud_file("cube.ply", small_cube());
  for (const char* name : {"out.ply", "out.obj", "out.stl", "out.off", "out.glb"}) {
    const Outcome run = run_program({"mesh", cube, "-o", path(name), "--json"});
    ASSERT_EQ(run.status, 0) << run.err;
    const Json json = run.json();
    EXPECT_EQ(json["closed"], true) << name;
    EXPECT_EQ(json["manifold"], true);
    EXPECT_EQ(json["self_intersections"], 0);
    EXPECT_EQ(json["components"], 1);
    EXPECT_EQ(json["euler"], 2);
    EXPECT_GT(json["crease_edges"], 400);
    EXPECT_EQ(json["crease_edges_kept"], json["crease_edges"]);
  }
  EXPECT_NE(read_mesh(path("out.ply")).vertices.find("scalar_crease"), nullptr);
  const Json info = run_program({"info", path("out.stl"), "--json"}).json();
  EXPECT_EQ(info["mesh"]["closed"], true);
  std::ifstream glb(path("out.glb"), std::ios::binary);
  std::string magic(4, ' ');
  glb.read(magic.data(), 4);
  EXPECT_EQ(magic, "glTF");
}

TEST_F(Mesh, badOptionsAndCloudsWithoutASurface) {
  const std::string cube = cloud_file("cube.ply", small_cube());
  EXPECT_EQ(run_program({"mesh", cube, "-o", path("a.xyz")}).status, 2);
  EXPECT_EQ(run_program({"mesh", cube, "-o", path("a.ply"), "--edge-length", "0"}).status, 2);
  PointCloud line;
  for (int i = 0; i < 100; ++i) line.points.push_back({0.1 * i, 0, 0});
  EXPECT_EQ(run_program({"mesh", cloud_file("line.ply", line), "-o", path("a.ply")}).status, 4);
  EXPECT_FALSE(std::ifstream(path("a.ply")).good());
}

}  // namespace
}  // namespace spigolo::test
