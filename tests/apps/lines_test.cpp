// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo lines: several outputs at once, the promises of its JSON, and clouds without features
#include <filesystem>

#include "apps/program.h"
#include "spigolo/io/cloud_file.h"
#include "spigolo/synth/synth.h"

namespace spigolo::test {
namespace {

class LinesVerb : public ProgramTest {
 protected:
  std::string cube() const { return cloud_file("cube.ply", small_cube()); }
  std::string sphere() const {
    SynthOptions options;
    options.shape = "sphere";
    options.points = 3000;
    return cloud_file("sphere.ply", make_cloud(options).cloud);
  }
};

TEST_F(LinesVerb, writesEveryFormatAtOnce) {
  const Outcome run = run_program({"lines", cube(), "-o", path("e.dxf"), "-o", path("e.step"), "-o",
                                   path("e.obj"), "-o", path("e.ply"), "-o", path("e.vtp"), "-o",
                                   path("e.json"), "-o", path("e.csv"), "--unit", "mm", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.json()["counts"]["curves"], 12);
  EXPECT_EQ(run.json()["counts"]["corners"], 8);
  EXPECT_EQ(run.json()["counts"]["lines"], 12);
  EXPECT_EQ(listing().size(), 8u);
}

TEST_F(LinesVerb, theJsonKeepsItsPromises) {
  ASSERT_EQ(run_program({"lines", cube(), "-o", path("e.json"), "--unit", "m"}).status, 0);
  const Json json = Json::parse(content_of(path("e.json")));
  EXPECT_EQ(json["schema"], "spigolo-lines-1");
  EXPECT_EQ(json["units"], "m");
  EXPECT_GT(json["spacing"].get<double>(), 0);
  ASSERT_EQ(json["curves"].size(), 12u);
  ASSERT_EQ(json["corners"].size(), 8u);
  for (const Json& curve : json["curves"]) {
    for (const char* key : {"id", "closed", "corners", "length", "angle_deg", "convex", "residual",
                            "polyline", "spline"})
      EXPECT_TRUE(curve.contains(key)) << key;
    const Json& corner = json["corners"][curve["corners"][0].get<std::size_t>()];
    EXPECT_EQ(corner["x"], curve["polyline"][0][0]);
    EXPECT_EQ(corner["y"], curve["polyline"][0][1]);
    EXPECT_NEAR(curve["angle_deg"]["mean"].get<double>(), 90, 0.1);
    const Json& spline = curve["spline"];
    EXPECT_EQ(spline["knots"].size(),
              spline["poles"].size() + spline["degree"].get<std::size_t>() + 1);
    EXPECT_EQ(spline["weights"].size(), spline["poles"].size());
  }
}

TEST_F(LinesVerb, theSameBytesOnEveryRunAndForAnyNumberOfThreads) {
  const std::string cloud = cube();
  for (const char* ending : {".dxf", ".step", ".json"}) {
    const std::string a = path(std::string("a") + ending), b = path(std::string("b") + ending);
    ASSERT_EQ(run_program({"lines", cloud, "-o", a, "--threads", "1"}).status, 0);
    ASSERT_EQ(run_program({"lines", cloud, "-o", b, "--threads", "2"}).status, 0);
    EXPECT_EQ(content_of(a), content_of(b)) << ending;
  }
}

TEST_F(LinesVerb, noFeatureIsAnEmptyFileAndAMessage) {
  const std::string cloud = sphere();
  const Outcome run = run_program({"lines", cloud, "-o", path("e.dxf"), "-o", path("e.json"), "-o",
                                   path("e.step"), "-o", path("e.ply")});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.err.find("no feature curve"), std::string::npos) << run.err;
  EXPECT_TRUE(Json::parse(content_of(path("e.json")))["curves"].empty());
  EXPECT_NE(content_of(path("e.dxf")).find("EOF"), std::string::npos);
}

TEST_F(LinesVerb, requireMakesNoFeatureAnError) {
  const std::string cloud = sphere();
  const auto before = listing();
  const Outcome run = run_program({"lines", cloud, "-o", path("e.dxf"), "--require"});
  EXPECT_EQ(run.status, 4);
  EXPECT_EQ(listing(), before);
}

TEST_F(LinesVerb, oneFullDiskLeavesNoOtherFile) {
  std::filesystem::create_symlink("/dev/full", path("full.ply"));
  const Outcome run =
      run_program({"lines", cube(), "-o", path("edges.json"), "-o", path("full.ply")});
  EXPECT_EQ(run.status, 1) << run.err;
  EXPECT_EQ(listing(), (std::vector<std::string>{"cube.ply", "full.ply"}));
}

TEST_F(LinesVerb, refusesWhatItCannotWrite) {
  const std::string cloud = cube();
  const Outcome unknown = run_program({"lines", cloud, "-o", path("e.dwg")});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_NE(unknown.err.find(".dxf"), std::string::npos) << unknown.err;
  EXPECT_EQ(run_program({"lines", cloud, "-o", path("e.dxf"), "--unit", "yard"}).status, 2);
  EXPECT_EQ(run_program({"lines", cloud, "-o", path("e.step"), "--unit", "ft"}).status, 2);
  EXPECT_EQ(run_program({"lines", cloud, "-o", path("e.dxf"), "--tolerance", "-3"}).status, 2);
}

}  // namespace
}  // namespace spigolo::test
