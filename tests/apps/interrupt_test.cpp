// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// Ctrl-C leaves nothing behind
#include <csignal>

#include "apps/program.h"
#include "spigolo/io/cloud_file.h"
#include "support/clouds.h"

namespace spigolo::test {
namespace {

class Interrupt : public ProgramTest, public ::testing::WithParamInterface<int> {};

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

TEST_F(ProgramTest, interruptEndsAProgramThatWaitsForInput) {
  Program program({"detect", "-", "-o", path("out.ply")});
  program.send(SIGINT);  // early or late: before the handler stands the signal itself ends it
  EXPECT_EQ(program.finish().status, 130);
  EXPECT_TRUE(listing().empty());
}

}  // namespace
}  // namespace spigolo::test
