// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo blend: what its files and its JSON promise, and its messages
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "apps/program.h"
#include "spigolo/cad/cad_file.h"
#include "spigolo/cad/nurbs_shapes.h"
#include "spigolo/cad/step_writer.h"
#include "spigolo/core/random.h"
#include "spigolo/io/cloud_file.h"

namespace spigolo::test {
namespace {

const Vec3 ez{0, 0, 1};

class BlendVerb : public ProgramTest {
 protected:
  BlendVerb()
      : cloud(cloud_file("cube.ply", small_cube())),
        tube(step("tube.step", {{nurbs_tube({{20.5, 20.5, 33}, ez}, 8, 28), {}}})) {}

  std::string step(const std::string& name, std::vector<CadFace> faces) const {
    StepContent content;
    content.faces = std::move(faces);
    return file(name, step_text(content));
  }
  Outcome run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "blend");
    return run_program(arguments);
  }
  void expect_failure(int status, const std::string& why,
                      const std::vector<std::string>& arguments) {
    const std::vector<std::string> before = listing();
    const Outcome out = run(arguments);
    EXPECT_EQ(out.status, status) << out.err;
    EXPECT_NE(out.err.find(why), std::string::npos) << out.err;
    EXPECT_EQ(out.out, "");
    EXPECT_EQ(listing(), before);
  }
  std::string cloud, tube;
};

TEST_F(BlendVerb, writesCloudAndCollarAndReportsEachBorder) {
  const Outcome out = run({cloud, tube, "--start", "v1", "--radius", "4", "-o", path("out.ply"),
                           "-o", path("collar.step"), "--json"});
  ASSERT_EQ(out.status, 0) << out.err;
  EXPECT_EQ(out.err, "");
  const Json json = out.json();
  for (const char* key :
       {"points", "spacing", "noise", "removed", "collar_points", "nurbs_points", "method",
        "parameters", "borders", "seconds", "threads", "version", "warnings"})
    EXPECT_TRUE(json.contains(key)) << key;
  ASSERT_EQ(json["borders"].size(), 1u);
  const Json& border = json["borders"][0];
  for (const char* key : {"gap", "normal_error_deg", "ripple", "removed", "collar_points"})
    EXPECT_TRUE(border.contains(key)) << key;
  for (const char* side : {"nurbs", "cloud"})
    for (const char* key : {"mean", "max"})
      EXPECT_LT(border["normal_error_deg"][side][key].get<double>(), 10);
  EXPECT_EQ(json["parameters"]["radius"], 4);
  EXPECT_FALSE(json["parameters"].contains("height"));

  EXPECT_NE(content_of(path("out.ply"))
                .find("property double z\nproperty float nx\n"
                      "property float ny\nproperty float nz\n"
                      "property float scalar_source\n"),
            std::string::npos);
  const PointCloud blended = read_cloud(path("out.ply"));
  const auto source = values_of(blended, "scalar_source");
  EXPECT_EQ(json["points"], blended.size());
  EXPECT_EQ(std::count(source.begin(), source.end(), 2.0), json["collar_points"].get<int>());
  EXPECT_EQ(std::count(source.begin(), source.end(), 0.0) + json["removed"].get<int>(), 10088);

  const CadFile collar(path("collar.step"));
  ASSERT_EQ(collar.faces().size(), 1u);
  EXPECT_TRUE(collar.faces()[0].closed_u);
  const NurbsFace face = collar.face(0);
  EXPECT_NEAR(point_at(face.surface, 0.3, 1).z, 41, 1e-2);
  EXPECT_NEAR(
      std::hypot(point_at(face.surface, 0.3, 0).x - 20.5, point_at(face.surface, 0.3, 0).y - 20.5),
      8, 1e-3);
}

TEST_F(BlendVerb, sameBytesForAnyThreadsAndAgain) {
  for (const char* threads : {"1", "3"})
    ASSERT_EQ(run({cloud, tube, "-o", path(std::string(threads) + ".ply"), "-o",
                   path(std::string(threads) + ".step"), "--threads", threads})
                  .status,
              0);
  EXPECT_EQ(content_of(path("1.ply")), content_of(path("3.ply")));
  EXPECT_EQ(content_of(path("1.step")), content_of(path("3.step")));
}

TEST_F(BlendVerb, sharpLabelsEdgesButNeverTheCollar) {
  ASSERT_EQ(run({cloud, tube, "--sharp", "-o", path("out.ply")}).status, 0);
  const PointCloud blended = read_cloud(path("out.ply"));
  const auto source = values_of(blended, "scalar_source"), kind = values_of(blended, "scalar_kind");
  // Face and collar are smooth before; the cube's own samples lie on it.
  ASSERT_EQ(run({cloud, tube, "-o", path("smooth.ply")}).status, 0);
  const PointCloud smooth = read_cloud(path("smooth.ply"));
  ASSERT_EQ(smooth.size(), blended.size());
  for (std::size_t i = 0; i < smooth.size(); ++i)
    EXPECT_LE(distance(smooth.points[i], blended.points[i]), source[i] == 0 ? 1e-3 : 0) << i;
  std::size_t edges = 0, on_collar = 0, beside = 0;
  for (std::size_t i = 0; i < kind.size(); ++i) {
    const bool feature = kind[i] == 1 || kind[i] == 2;
    edges += feature;
    on_collar += feature && source[i] == 2;
    beside += feature && std::abs(blended.points[i].z - 41) < 6 &&
              std::hypot(blended.points[i].x - 20.5, blended.points[i].y - 20.5) < 14;
  }
  EXPECT_NEAR(static_cast<double>(edges), 488, 25);
  EXPECT_EQ(on_collar, 0u);
  EXPECT_EQ(beside, 0u);
}

TEST_F(BlendVerb, meshIsOneSoundPiece) {
  const Outcome out =
      run({cloud, tube, "-o", path("out.ply"), "--mesh", path("mesh.ply"), "--json"});
  ASSERT_EQ(out.status, 0) << out.err;
  const Json mesh = out.json()["mesh"];
  EXPECT_EQ(mesh["components"], 1);
  EXPECT_TRUE(mesh["manifold"].get<bool>());
  EXPECT_EQ(mesh["self_intersections"], 0);
  EXPECT_GT(read_mesh(path("mesh.ply")).triangles.size(), 10000u);
}

TEST_F(BlendVerb, igesGivesWhatStepGives) {
  StepContent content;
  content.faces = {{nurbs_tube({{20.5, 20.5, 33}, ez}, 8, 28), {}}};
  const std::string iges = file("tube.igs", iges_text(content));
  ASSERT_EQ(run({cloud, tube, "-o", path("step.ply")}).status, 0);
  ASSERT_EQ(run({cloud, iges, "-o", path("iges.ply")}).status, 0);
  const PointCloud a = read_cloud(path("step.ply")), b = read_cloud(path("iges.ply"));
  EXPECT_NEAR(static_cast<double>(a.size()), static_cast<double>(b.size()), 10);
}

TEST_F(BlendVerb, linearIsThere) {
  const Outcome out = run({cloud, tube, "--method", "linear", "--height", "4", "--width", "5.7",
                           "-o", path("out.ply"), "--json"});
  ASSERT_EQ(out.status, 0) << out.err;
  EXPECT_GT(out.json()["borders"][0]["normal_error_deg"]["nurbs"]["mean"].get<double>(), 10);
  expect_failure(2, "linear",
                 {cloud, tube, "--method", "linear", "-o", path("x.ply"), "-o", path("x.step")});
}

// Whatever the damage, the program ends by itself: with the file's faces, or saying that it is bad.
TEST_F(BlendVerb, damagedCadFilesNeverCrashTheProgram) {
  StepContent content;
  content.faces = {{nurbs_tube({{20.5, 20.5, 33}, ez}, 8, 28), {}}};
  const std::string iges = iges_text(content);
  Random random(4);
  std::size_t refused = 0;
  for (const bool is_step : {true, false}) {
    const std::string& good = is_step ? content_of(tube) : iges;
    std::vector<std::string> damaged;
    for (std::size_t i = 0; i < 20; i += 3) damaged.push_back(good.substr(0, good.size() * i / 20));
    for (int i = 0; i < 8; ++i) {
      damaged.push_back(good);
      for (int k = 0; k < 10; ++k)
        damaged.back()[random.below(good.size())] = static_cast<char>(random.below(256));
    }
    for (std::size_t i = 0; i < damaged.size(); ++i) {
      const std::string name = "damaged." + std::string(is_step ? "step" : "igs");
      const Outcome out = run_program({"info", file(name, damaged[i])});
      EXPECT_TRUE(out.status == 0 || out.status == 3) << i << ": " << out.err;
      if (out.status == 0) continue;
      ++refused;
      EXPECT_NE(out.err.find(name), std::string::npos) << out.err;
    }
  }
  EXPECT_GT(refused, 14u);
}

TEST_F(BlendVerb, oneFullDiskLeavesNoOtherFile) {
  std::filesystem::create_symlink("/dev/full", path("full.ply"));
  const Outcome run =
      run_program({"blend", cloud, tube, "-o", path("collar.step"), "-o", path("full.ply")});
  EXPECT_EQ(run.status, 1) << run.err;
  EXPECT_FALSE(std::filesystem::exists(path("collar.step")));
}

TEST_F(BlendVerb, badInputsEachWithTheirOwnMessage) {
  const std::string out = path("out.ply");
  const std::string two =
      step("two.step", {{nurbs_tube({{20.5, 20.5, 33}, ez}, 8, 28), {}},
                        {CadCylinder{{20.5, 20.5, 36}, ez, {1, 0, 0}, 6, 20}, {}}});
  expect_failure(4, "face 1  cylinder", {cloud, two, "-o", out});
  expect_failure(2, "no face 7", {cloud, two, "--face", "7", "-o", out});
  StepContent line;
  line.curves = {CadLine{{0, 0, 0}, {1, 0, 0}}};
  expect_failure(4, "holds no face", {cloud, file("line.step", step_text(line)), "-o", out});
  const std::string text = content_of(tube);
  expect_failure(3, "damaged", {cloud, file("cut.step", text.substr(0, 3000)), "-o", out});
  expect_failure(3, "cannot be read", {cloud, path("none.step"), "-o", out});
  expect_failure(2, "above 0", {cloud, tube, "--radius", "0", "-o", out});
  expect_failure(2, "above 0", {cloud, tube, "--radius=-3", "-o", out});
  expect_failure(2, "none of u0", {cloud, tube, "--start", "w7", "-o", out});
  expect_failure(2, "--keep", {cloud, tube, "--keep", "-w", "-o", out});
  expect_failure(4, "lies inside", {cloud, tube, "--start", "v0", "-o", out});
  const std::string away = step("away.step", {{nurbs_tube({{20.5, 20.5, 60}, ez}, 8, 28), {}}});
  expect_failure(4, "do not meet", {cloud, away, "--start", "v1", "-o", out});
  expect_failure(4, "wider than the face",
                 {cloud, tube, "--height", "40", "--width", "3", "-o", out});
  const std::string low = step("low.step", {{nurbs_tube({{20.5, 20.5, 33}, ez}, 8, 9), {}}});
  expect_failure(4, "wider than the face", {cloud, low, "--start", "v1", "-o", out});
  const std::string u =
      step("u.step", {{nurbs_u_tube({{15.5, 20.5, 36}, ez}, {1, 0, 0}, 4, 14, 10), {}}});
  expect_failure(4, "overlap",
                 {cloud, u, "--start", "v=0.5+", "--start", "v=0.5-", "--height", "3", "--width",
                  "3", "-o", out});
  const std::string flat = step("flat.step", {{nurbs_sheet(10, 10, 4,
                                                           [](double x, double) {
                                                             return Vec3{x, 0, 0};
                                                           }),
                                               {}}});
  expect_failure(4, "no area", {cloud, flat, "-o", out});
  const std::string fin = step("fin.step", {{nurbs_sheet(20, 20, 4,
                                                         [](double x, double y) {
                                                           return Vec3{20.5, x + 10.5, y + 33};
                                                         }),
                                             {}}});
  expect_failure(4, "ends inside the cloud at (20.50, 10.50, 41.00)",
                 {cloud, fin, "--start", "v1", "-o", out});
  expect_failure(2, "not both",
                 {cloud, tube, "--radius", "3", "--height", "3", "--width", "3", "-o", out});
  expect_failure(2, "give both", {cloud, tube, "--height", "3", "-o", out});
  expect_failure(3, "none.ply", {path("none.ply"), tube, "-o", out});
  expect_failure(2, "m.xyz", {cloud, tube, "--mesh", path("m.xyz"), "-o", out});
}

}  // namespace
}  // namespace spigolo::test
