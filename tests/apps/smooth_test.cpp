// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo smooth: what its file and its JSON promise, and what it refuses
#include <filesystem>

#include "apps/program.h"
#include "spigolo/io/cloud_file.h"
#include "support/clouds.h"

namespace spigolo::test {
namespace {

class Smooth : public ProgramTest {};

TEST_F(Smooth, keepsCountOrderAndCarriedAttributes) {
  PointCloud cube = small_cube();
  std::vector<double> number(cube.size());
  for (std::size_t i = 0; i < number.size(); ++i) number[i] = static_cast<double>(i);
  cube.set("number", ScalarType::float64, number);
  cube.set("nx", ScalarType::float32, std::vector<double>(cube.size(), 7));
  const std::string in = cloud_file("in.ply", cube);
  for (const char* method : {"plain", "feature-line"}) {
    const Outcome run = run_program({"smooth", in, "-o", path("out.ply"), "--method", method});
    ASSERT_EQ(run.status, 0) << run.err;
    const PointCloud out = read_cloud(path("out.ply"));
    ASSERT_EQ(out.size(), cube.size());
    EXPECT_EQ(values_of(out, "number"), number);
    const auto nx = values_of(out, "nx"), ny = values_of(out, "ny"), nz = values_of(out, "nz"),
               deviation = values_of(out, "scalar_deviation");
    for (std::size_t i = 0; i < out.size(); ++i) {
      EXPECT_NEAR(nx[i] * nx[i] + ny[i] * ny[i] + nz[i] * nz[i], 1, 1e-5);
      EXPECT_NEAR(deviation[i], distance(out.points[i], cube.points[i]), 1e-5);
    }
    for (const char* name :
         {"scalar_curvature1", "scalar_curvature2", "scalar_kind", "scalar_status"})
      EXPECT_EQ(values_of(out, name).size(), cube.size());
  }
}

TEST_F(Smooth, jsonTellsWhatWasDone) {
  const std::string in = cloud_file("in.ply", small_cube());
  const Outcome run = run_program({"smooth", in, "-o", path("out.ply"), "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  const Json json = run.json();
  EXPECT_EQ(json["points"], 10088);
  for (const char* key : {"spacing", "noise", "counts", "deviation", "method", "parameters",
                          "seconds", "threads", "version", "warnings"})
    EXPECT_TRUE(json.contains(key)) << key;
  std::size_t all = 0;
  for (const auto& [name, count] : json["counts"].items()) all += count.get<std::size_t>();
  EXPECT_EQ(all, 10088u);
  EXPECT_EQ(json["parameters"]["k"], 32);
  for (const char* stage : {"read", "index", "detect", "project", "write", "total"})
    EXPECT_TRUE(json["seconds"].contains(stage)) << stage;
}

TEST_F(Smooth, labelsOfDetectGiveTheSameSurface) {
  const std::string in = cloud_file("in.ply", small_cube());
  ASSERT_EQ(run_program({"detect", in, "-o", path("labels.ply")}).status, 0);
  ASSERT_EQ(run_program({"smooth", in, "-o", path("a.ply")}).status, 0);
  const Outcome run =
      run_program({"smooth", in, "-o", path("b.ply"), "--features", path("labels.ply")});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(content_of(path("a.ply")), content_of(path("b.ply")));
}

TEST_F(Smooth, labelsOfAnotherCloudAreRefused) {
  const PointCloud cube = small_cube();
  PointCloud other = cube, fewer = cube;
  other.points[77].x += 0.1;
  fewer.points.pop_back();
  const std::string in = cloud_file("in.ply", cube);
  for (const PointCloud& labelled : {other, fewer}) {
    const std::string file = cloud_file("other.ply", labelled);
    ASSERT_EQ(run_program({"detect", file, "-o", path("labels.ply")}).status, 0);
    const Outcome run =
        run_program({"smooth", in, "-o", path("out.ply"), "--features", path("labels.ply")});
    EXPECT_EQ(run.status, 3);
    EXPECT_NE(run.err.find("labels of another cloud"), std::string::npos) << run.err;
  }
  const Outcome bare = run_program({"smooth", in, "-o", path("out.ply"), "--features", in});
  EXPECT_EQ(bare.status, 3);
  EXPECT_NE(bare.err.find("scalar_kind"), std::string::npos) << bare.err;
  EXPECT_FALSE(std::filesystem::exists(path("out.ply")));
}

TEST_F(Smooth, refusesWhatItCannotDo) {
  const std::string in = cloud_file("in.ply", small_cube()), out = path("out.ply");
  EXPECT_EQ(run_program({"smooth", in, "-o", out, "--method", "magic"}).status, 2);
  EXPECT_EQ(run_program({"smooth", in, "-o", out, "--smoothing", "-1"}).status, 2);
  EXPECT_EQ(run_program({"smooth", in, "-o", out, "--k", "3"}).status, 2);
  EXPECT_EQ(run_program({"smooth", in, "-o", path("out.obj")}).status, 2);
  EXPECT_EQ(run_program({"smooth", path("none.ply"), "-o", out}).status, 3);
  EXPECT_EQ(run_program({"smooth", file("few.xyz", "0 0 0\n1 0 0\n0 1 0\n"), "-o", out}).status, 4);
  EXPECT_FALSE(std::filesystem::exists(out));
}

}  // namespace
}  // namespace spigolo::test
