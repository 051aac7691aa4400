// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo mesh: every format, its JSON, its refusals
#include <fstream>
#include <set>

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

TEST_F(Mesh, theReportKnowsTrianglesHolesAndParts) {
  const std::string cube = cloud_file("cube.ply", small_cube());
  const Json json = run_program({"mesh", cube, "-o", path("out.ply"), "--json"}).json();
  EXPECT_EQ(json["parts"], 1);
  EXPECT_EQ(json["uncovered"], 0);
  EXPECT_EQ(json["holes_left"], 0);
  EXPECT_GT(json["triangle_quality"]["smallest_angle_mean"], 40);
  EXPECT_LT(json["triangle_quality"]["slim_share"], 0.01);
  EXPECT_LT(json["triangle_quality"]["aspect_mean"], 2.1);
}

TEST_F(Mesh, edgesLookSharpInViewers) {
  const std::string cube = cloud_file("cube.ply", small_cube());
  ASSERT_EQ(run_program({"mesh", cube, "-o", path("out.obj")}).status, 0);
  std::ifstream obj(path("out.obj"));
  std::set<std::string> groups;
  std::size_t lines = 0;
  for (std::string line; std::getline(obj, line);) {
    if (line.rfind("s ", 0) == 0) groups.insert(line);
    lines += line.rfind("l ", 0) == 0;
  }
  EXPECT_EQ(groups.size(), 6U);  // one a face of the cube
  EXPECT_GT(lines, 11U);
  ASSERT_EQ(run_program({"mesh", cube, "-o", path("out.ply")}).status, 0);
  const TriangleMesh mesh = read_mesh(path("out.ply"));
  const Attribute* crease = mesh.vertices.find("scalar_crease");
  ASSERT_NE(crease, nullptr);
  std::size_t marked = 0;
  for (const double c : crease->values) marked += c == 1;
  EXPECT_GT(marked, 400U);
  EXPECT_LT(marked, mesh.vertices.size() / 4);
}

TEST_F(Mesh, badOptionsAndCloudsWithoutASurface) {
  const std::string cube = cloud_file("cube.ply", small_cube());
  EXPECT_EQ(run_program({"mesh", cube, "-o", path("a.xyz")}).status, 2);
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {"--edge-length", "0"},  {"--edge-length", "inf"}, {"--edge-length", "nan"},
      {"--chord-error", "-1"}, {"--sensitivity", "1.5"}, {"--sensitivity", "nan"},
      {"--smoothing", "1e9"}};
  for (const auto& [option, value] : wrong)
    EXPECT_EQ(run_program({"mesh", cube, "-o", path("a.ply"), option, value}).status, 2)
        << option << " " << value;
  const Outcome ending = run_program({"mesh", cube, "-o", path("a.png")});
  EXPECT_NE(ending.err.find(".glb"), std::string::npos) << ending.err;
  PointCloud line;
  for (int i = 0; i < 100; ++i) line.points.push_back({0.1 * i, 0, 0});
  EXPECT_EQ(run_program({"mesh", cloud_file("line.ply", line), "-o", path("a.ply")}).status, 4);
  EXPECT_FALSE(std::ifstream(path("a.ply")).good());
}

}  // namespace
}  // namespace spigolo::test
