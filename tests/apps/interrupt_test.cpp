// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// Ctrl-C leaves nothing behind
#include <algorithm>
#include <csignal>

#include "apps/program.h"
#include "spigolo/io/cloud_file.h"
#include "support/clouds.h"

namespace spigolo::test {
namespace {

class Interrupt : public ProgramTest, public ::testing::WithParamInterface<int> {
 protected:
  // True once out.xyz is there, or part of it in a temporary file.
  bool writing() const {
    std::error_code gone;
    const auto begun = [&](const std::string& name) {
      const auto size = std::filesystem::file_size(path(name), gone);
      return name != "in.ply" && !gone && size > 0;
    };
    const std::vector<std::string> names = listing();
    return std::any_of(names.begin(), names.end(), begun);
  }
};

TEST_P(Interrupt, endsALongDetect) {
  const std::string in = cloud_file("in.ply", PointCloud{random_sphere(300000, 1), {}});
  file("out.ply", "older");
  Program program({"detect", in, "-o", path("out.ply"), "--progress", "always", "--threads", "1"});
  program.wait_for_message();  // the bar: the work has begun
  program.send(GetParam());
  const Outcome run = program.finish();
  EXPECT_EQ(run.status, 130);
  EXPECT_EQ(run.out, "");
  EXPECT_NE(run.err.find("spigolo: cancelled"), std::string::npos) << run.err;
  EXPECT_EQ(content_of(path("out.ply")), "older");
  EXPECT_EQ(listing(), (std::vector<std::string>{"in.ply", "out.ply"}));
}

INSTANTIATE_TEST_SUITE_P(Signals, Interrupt, ::testing::Values(SIGINT, SIGTERM),
                         [](const auto& test) { return test.param == SIGINT ? "int" : "term"; });

TEST_P(Interrupt, leavesNoHalfWrittenFile) {
  const std::string in = cloud_file("in.ply", PointCloud{random_sphere(300000, 1), {}});
  Program program({"convert", in, "-o", path("out.xyz")});
  while (!writing()) continue;
  program.send(GetParam());
  const Outcome run = program.finish();
  const bool was_done = run.status == 0;  // it may be quicker than the signal
  EXPECT_TRUE(was_done || run.status == 130) << run.status;
  EXPECT_EQ(listing(), was_done ? (std::vector<std::string>{"in.ply", "out.xyz"})
                                : std::vector<std::string>{"in.ply"});
}

TEST_F(ProgramTest, interruptEndsAProgramThatWaitsForInput) {
  Program program({"detect", "-", "-o", path("out.ply")});
  program.send(SIGINT);  // early or late: before the handler stands the signal itself ends it
  EXPECT_EQ(program.finish().status, 130);
  EXPECT_TRUE(listing().empty());
}

}  // namespace
}  // namespace spigolo::test
