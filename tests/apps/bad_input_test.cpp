// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// what people feed it by mistake: the exit status, the message, and nothing left behind
#include <filesystem>

#include "apps/program.h"
#include "spigolo/io/cloud_file.h"
#include "support/clouds.h"

namespace spigolo::test {
namespace {

constexpr const char* ply_header =
    "ply\nformat binary_little_endian 1.0\nelement vertex %\nproperty double x\nproperty double "
    "y\nproperty double z\nend_header\n";

std::string header_claiming(const std::string& count) {
  std::string header = ply_header;
  return header.replace(header.find('%'), 1, count);
}

class BadInput : public ProgramTest {
 protected:
  /// Runs detect on it over an older output; the message must hold `part`, and nothing may change.
  void expect_failure(const std::string& input, int status, const std::string& part) const {
    file("out.ply", "older");
    const auto before = listing();
    const Outcome run = run_program({"detect", input, "-o", path("out.ply"), "--json"});
    EXPECT_EQ(run.status, status) << run.err;
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(run.err.rfind("spigolo: ", 0), 0u) << run.err;
    EXPECT_NE(run.err.find(part), std::string::npos) << run.err;
    EXPECT_EQ(run.err.find('\x1b'), std::string::npos);
    EXPECT_EQ(content_of(path("out.ply")), "older");
    EXPECT_EQ(listing(), before);
  }
  void expect_failure(const PointCloud& cloud, int status, const std::string& part) const {
    expect_failure(cloud_file("in.ply", cloud), status, part);
  }
};

TEST_F(BadInput, missingFile) { expect_failure(path("none.ply"), 3, "none.ply"); }

TEST_F(BadInput, emptyFile) {
  expect_failure(file("in.ply", ""), 3, "in.ply");
  expect_failure(file("in.xyz", ""), 3, "empty");
}

TEST_F(BadInput, folder) {
  std::filesystem::create_directory(path("in.ply"));
  expect_failure(path("in.ply"), 3, "is a folder");
}

TEST_F(BadInput, textNamedPly) {
  expect_failure(file("in.ply", "Dear reader,\nno points here.\n"), 3, "in.ply");
}

TEST_F(BadInput, fileCutInTheMiddle) {
  const std::string whole = content_of(cloud_file("whole.ply", small_cube()));
  expect_failure(file("in.ply", whole.substr(0, whole.size() / 2)), 3, "in.ply");
}

TEST_F(BadInput, headerClaimingATrillionPoints) {
  expect_failure(file("in.ply", header_claiming("1000000000000") + "12345678"), 3, "in.ply");
}

TEST_F(BadInput, unknownEnding) {
  const Outcome run = run_program({"detect", file("in.docx", "x"), "-o", path("out.ply")});
  EXPECT_EQ(run.status, 2);
  EXPECT_NE(run.err.find(".ply"), std::string::npos) << "names the endings it knows: " << run.err;
}

TEST_F(BadInput, tooFewPoints) {
  expect_failure(PointCloud{{{1, 2, 3}}, {}}, 4, "1 different places");
  expect_failure(PointCloud{random_sphere(3, 1), {}}, 4, "3 different places");
}

TEST_F(BadInput, allPointsEqual) {
  expect_failure(PointCloud{std::vector<Vec3>(50, Vec3{1, 2, 3}), {}}, 4, "different places");
}

TEST_F(BadInput, allPointsOnALine) {
  std::vector<Vec3> line;
  for (int i = 0; i < 200; ++i) line.push_back({0.1 * i, 0.2 * i, -0.3 * i});
  expect_failure(PointCloud{line, {}}, 4, "one line");
}

TEST_F(BadInput, noFinitePoint) {
  expect_failure(PointCloud{std::vector<Vec3>(20, Vec3{not_a_number, 0, infinity}), {}}, 4,
                 "finite");
}

TEST_F(BadInput, overTheMemoryAllowed) {
  const std::string cube = cloud_file("cube.ply", small_cube());
  // More than the file, less than the work needs.
  const Outcome work = run_program({"detect", cube, "-o", path("out.ply"), "--memory", "1M"});
  EXPECT_EQ(work.status, 5) << work.err;
  EXPECT_NE(work.err.find("--memory"), std::string::npos) << work.err;
  const Outcome reading = run_program({"detect", cube, "-o", path("out.ply"), "--memory", "10K"});
  EXPECT_EQ(reading.status, 5) << reading.err;
  EXPECT_EQ(listing(), std::vector<std::string>{"cube.ply"});
}

TEST_F(BadInput, outputsAreCheckedBeforeTheInputIsRead) {
  const std::string missing = path("none.ply");
  const Outcome folder = run_program({"detect", missing, "-o", path("no/such/folder/out.ply")});
  EXPECT_EQ(folder.status, 2) << folder.err;
  EXPECT_NE(folder.err.find("no/such/folder"), std::string::npos) << folder.err;
  EXPECT_EQ(run_program({"detect", missing, "-o", path("out.stl")}).status, 2);
  EXPECT_EQ(run_program({"convert", missing, "-o", path("out.docx")}).status, 2);
  EXPECT_EQ(run_program({"render", missing, "-o", path("out.jpg")}).status, 2);
  EXPECT_EQ(run_program({"detect", missing, "-o", "-", "--json"}).status, 2);
}

TEST_F(BadInput, aFullDiskIsAFailureInside) {
  std::filesystem::create_symlink("/dev/full", path("full.ply"));
  const Outcome run = run_program({"synth", "cube", "-o", path("full.ply")});
  EXPECT_EQ(run.status, 1) << run.err;
  EXPECT_NE(run.err.find("full.ply"), std::string::npos) << run.err;
  EXPECT_EQ(run.out, "");
}

TEST_F(BadInput, damagedCadFiles) {
  for (const char* name : {"part.step", "part.STP", "part.iges", "part.igs"}) {
    for (const char* content : {"", "solid cube", "ISO-10303-21;\nHEADER;\n"}) {
      const Outcome run = run_program({"info", file(name, content)});
      EXPECT_EQ(run.status, 3) << name << ": " << content;
      EXPECT_NE(run.err.find(name), std::string::npos) << run.err;
      EXPECT_EQ(run.out, "");
    }
  }
}

TEST_F(BadInput, fewPointsAreEnoughWithASmallerK) {
  const std::string in = cloud_file("in.ply", PointCloud{random_sphere(19, 1), {}});
  const Outcome run = run_program(
      {"detect", in, "-o", path("out.ply"), "--method", "gauss-map", "--k", "20", "--json"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.err.find("warning: "), std::string::npos) << run.err;
  EXPECT_EQ(run.json()["k_used"], 18);
  EXPECT_EQ(run.json()["warnings"].size(), 1u);
  EXPECT_EQ(read_cloud(path("out.ply")).size(), 19u);
}

TEST_F(BadInput, optionsOfAnotherMethodAreNotIgnoredInSilence) {
  const std::string in = cloud_file("in.ply", PointCloud{random_sphere(200, 1), {}});
  const Outcome run = run_program({"detect", in, "-o", path("out.ply"), "--k", "12"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_NE(run.err.find("--k has no effect with --method sheets"), std::string::npos) << run.err;
}

}  // namespace
}  // namespace spigolo::test
