// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// the command line itself: help, versions, wrong verbs and options, parameter files
#include "apps/program.h"
#include "spigolo/detect/detect.h"
#include "spigolo/io/cloud_file.h"

namespace spigolo::test {
namespace {

using ::testing::Test;

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

const std::vector<std::string> verbs = {"info",  "detect",  "smooth", "lines",  "mesh",
                                        "blend", "compare", "synth",  "render", "convert"};

TEST(Usage, helpNamesEveryVerb) {
  const Outcome help = run_program({"--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_EQ(help.err, "");
  for (const std::string& verb : verbs) EXPECT_TRUE(contains(help.out, "\n  " + verb + " "));
}

TEST(Usage, everyVerbHelpsWithAnExample) {
  for (const std::string& verb : verbs) {
    const Outcome help = run_program({verb, "--help"});
    EXPECT_EQ(help.status, 0) << verb;
    EXPECT_TRUE(contains(help.out, "Example:\n  spigolo " + verb + " ")) << help.out;
    for (const char* option : {"--threads", "--json", "--quiet", "--progress", "--seed", "--params",
                               "--save-params", "--memory"})
      EXPECT_TRUE(contains(help.out, option)) << verb << " " << option;
  }
}

TEST(Usage, versionIsOneLine) {
  const Outcome version = run_program({"--version"});
  EXPECT_EQ(version.status, 0);
  EXPECT_EQ(version.out.rfind("spigolo ", 0), 0u);
  EXPECT_EQ(version.out.find('\n'), version.out.size() - 1);
}

TEST(Usage, wrongVerbsGetTheNearestOne) {
  const Outcome typo = run_program({"detekt", "a.ply"});
  EXPECT_EQ(typo.status, 2);
  EXPECT_EQ(typo.out, "");
  EXPECT_TRUE(contains(typo.err, "did you mean 'detect'?")) << typo.err;
  EXPECT_TRUE(contains(typo.err, "spigolo --help")) << typo.err;
  EXPECT_EQ(run_program({}).status, 2);
  EXPECT_EQ(run_program({"--json", "info"}).status, 2);
}

TEST_F(ProgramTest, wrongOptionsGetTheNearestOne) {
  const Outcome typo = run_program({"detect", "a.ply", "-o", path("b.ply"), "--sigmma", "0.1"});
  EXPECT_EQ(typo.status, 2);
  EXPECT_TRUE(contains(typo.err, "unknown option '--sigmma'; did you mean '--sigma'?")) << typo.err;
  EXPECT_TRUE(contains(typo.err, "spigolo detect --help")) << typo.err;
  EXPECT_EQ(run_program({"detect", "a.ply"}).status, 2);
  EXPECT_EQ(run_program({"detect", "-o", path("b.ply")}).status, 2);
  EXPECT_EQ(run_program({"detect", "a.ply", "b.ply", "-o", path("b.ply")}).status, 2);
}

TEST_F(ProgramTest, valuesOutOfRangeAreUsageErrors) {
  const std::string cube = cloud_file("cube.ply", small_cube());
  const std::vector<std::pair<std::string, std::string>> wrong = {{"--k", "3"},
                                                                  {"--k", "65"},
                                                                  {"--k", "-5"},
                                                                  {"--k", "many"},
                                                                  {"--sigma", "0"},
                                                                  {"--sigma", "1.6"},
                                                                  {"--sigma", "nan"},
                                                                  {"--flatness", "-0.1"},
                                                                  {"--flatness", "1.1"},
                                                                  {"--min-cluster", "0.6"},
                                                                  {"--method", "planes"},
                                                                  {"--sensitivity", "1.5"},
                                                                  {"--threads", "0"},
                                                                  {"--threads", "two"},
                                                                  {"--progress", "maybe"},
                                                                  {"--memory", "lots"},
                                                                  {"--memory", "5MG"},
                                                                  {"--seed", "-1"}};
  for (const auto& [option, value] : wrong) {
    const Outcome run = run_program({"detect", cube, "-o", path("out.ply"), option, value});
    EXPECT_EQ(run.status, 2) << option << " " << value << ": " << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(run.err.rfind("spigolo: ", 0), 0u) << run.err;
  }
  EXPECT_EQ(listing(), std::vector<std::string>{"cube.ply"});
}

TEST_F(ProgramTest, unknownMethodsAreAnsweredWithTheKnownOnes) {
  const Outcome run = run_program({"detect", "a.ply", "-o", path("out.ply"), "--method", "planes"});
  EXPECT_EQ(run.status, 2);
  for (const char* method : {"sheets", "gauss-map", "gauss-map-global"})
    EXPECT_TRUE(contains(run.err, method)) << run.err;
}

TEST_F(ProgramTest, savedParametersGiveTheSameBytes) {
  const std::string cube = cloud_file("cube.ply", small_cube());
  const std::string params = path("params.json");
  ASSERT_EQ(run_program({"detect", cube, "-o", path("a.ply"), "--method", "gauss-map-global", "--k",
                         "16", "--sigma", "0.2", "--save-params", params})
                .status,
            0);
  const Json saved = Json::parse(content_of(params));
  EXPECT_EQ(saved["verb"], "detect");
  EXPECT_EQ(saved["method"], "gauss-map-global");
  EXPECT_EQ(saved["k"], 16);
  EXPECT_EQ(saved["sigma"], 0.2);
  EXPECT_EQ(saved["flatness"], DetectOptions{}.flatness);
  EXPECT_GT(saved["min_cluster"], 0.0);  // chosen by the noise

  const std::string again = path("again.json");
  ASSERT_EQ(
      run_program({"detect", cube, "-o", path("b.ply"), "--params", params, "--save-params", again})
          .status,
      0);
  EXPECT_EQ(content_of(path("a.ply")), content_of(path("b.ply")));
  EXPECT_EQ(content_of(params), content_of(again));
}

TEST_F(ProgramTest, theCommandLineWinsOverTheParameterFile) {
  const std::string cube = cloud_file("cube.ply", small_cube());
  const std::string params =
      file("p.json", R"({"method": "gauss-map", "k": 12, "min-cluster": 0.2})");
  const Outcome run =
      run_program({"detect", cube, "-o", path("a.ply"), "--params", params, "--k", "24", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_EQ(run.json()["parameters"]["k"], 24);
  EXPECT_EQ(run.json()["parameters"]["min_cluster"], 0.2);
}

TEST_F(ProgramTest, parameterFilesAreChecked) {
  const auto status = [&](const std::string& content) {
    return run_program({"synth", "cube", "-o", path("a.ply"), "--params", file("p.json", content)})
        .status;
  };
  EXPECT_EQ(status(R"({"noise": 0.1})"), 0);
  EXPECT_EQ(status(R"({"nois": 0.1})"), 2);
  EXPECT_EQ(status(R"({"noise": "much"})"), 2);
  EXPECT_EQ(status(R"({"verb": "detect"})"), 2);
  EXPECT_EQ(status(R"({"noise": )"), 3);
  EXPECT_EQ(status("[1]"), 3);
  EXPECT_EQ(status(""), 3);
  for (const char* no_file : {"none", "."}) {
    const std::string params = path(no_file);
    EXPECT_EQ(run_program({"synth", "cube", "-o", path("a.ply"), "--params", params}).status, 3);
  }
}

TEST_F(ProgramTest, progressGoesToStderrAndIsErased) {
  const std::string cube = cloud_file("cube.ply", small_cube());
  const Outcome always =
      run_program({"detect", cube, "-o", path("a.ply"), "--progress", "always", "--json"});
  EXPECT_EQ(always.status, 0);
  EXPECT_TRUE(contains(always.err, "%")) << always.err;
  EXPECT_EQ(always.err.back(), '\r');
  EXPECT_EQ(always.err.find('\x1b'), std::string::npos);
  EXPECT_TRUE(always.json().is_object());

  const Outcome piped = run_program({"detect", cube, "-o", path("b.ply")});
  EXPECT_EQ(piped.err, "") << "stderr is no terminal";
  EXPECT_EQ(run_program({"detect", cube, "-o", path("b.ply"), "--quiet"}).out, "");
}

}  // namespace
}  // namespace spigolo::test
