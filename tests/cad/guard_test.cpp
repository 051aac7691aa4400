// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// The guarded reader: whatever its child does, the caller gets a file or an error that names it
#include "spigolo/cad/cad_guard.h"

#include <gtest/gtest.h>

#include "spigolo/cad/cad_stream.h"
#include "spigolo/cad/nurbs_shapes.h"
#include "spigolo/core/error.h"
#include "spigolo/core/random.h"

namespace spigolo {
namespace {

constexpr const char* name = "/nowhere/part.step";

NurbsFace trimmed_tube() {
  NurbsFace face;
  face.surface = nurbs_tube({{1, 2, 3}, {0, 0, 1}}, 2, 5);
  face.u = {0, 1}, face.v = {0.25, 0.75};
  face.closed_u = face.reversed = true;
  face.trims = {{{0, 0.25}, {1, 0.25}}, {{1, 0.75}, {0.5, 0.7}, {0, 0.75}}};
  return face;
}

CadSummary some_summary() {
  CadSummary s;
  s.format = "STEP", s.unit = "mm";
  s.faces.resize(2);
  s.faces[0].type = "cylinder", s.faces[0].area = 7, s.faces[0].closed_u = true;
  s.faces[1].type = "plane", s.faces[1].v = {2, 3}, s.faces[1].trimmed = true;
  s.faces[1].bounds.add({1, 2, 3});
  s.free_curves = 4, s.free_points = 5;
  s.bounds.add({7, 8, 9});
  return s;
}

TEST(CadStream, bringsBackWhatWasPutIn) {
  const NurbsFace face = trimmed_tube(), back = decode_face(encode(face));
  EXPECT_EQ(back.surface.poles, face.surface.poles);
  EXPECT_EQ(back.surface.weights, face.surface.weights);
  EXPECT_EQ(back.surface.knots_u, face.surface.knots_u);
  EXPECT_EQ(back.surface.period_u, face.surface.period_u);
  EXPECT_EQ(back.v.end, 0.75);
  EXPECT_TRUE(back.closed_u && !back.closed_v && back.reversed);
  ASSERT_EQ(back.trims.size(), 2u);
  EXPECT_EQ(back.trims[1][1].v, 0.7);
  const CadSummary given = some_summary(), got = decode_summary(encode(given));
  EXPECT_EQ(got.unit, "mm");
  ASSERT_EQ(got.faces.size(), 2u);
  EXPECT_EQ(got.faces[1].type, "plane");
  EXPECT_TRUE(got.faces[0].closed_u && !got.faces[0].trimmed && got.faces[1].trimmed);
  EXPECT_EQ(got.faces[1].bounds.max, (Vec3{1, 2, 3}));
  EXPECT_EQ(got.free_points, 5u);
  EXPECT_EQ(got.bounds.min, (Vec3{7, 8, 9}));
  EXPECT_EQ(encode(got), encode(given));
}

TEST(CadStream, refusesWhatIsCutOrTooLongOrCounterfeit) {
  const std::string face = encode(trimmed_tube()), summary = encode(some_summary());
  for (std::size_t size = 0; size < face.size(); size += 7)
    EXPECT_THROW(decode_face(face.substr(0, size)), Error) << size;
  for (std::size_t size = 0; size < summary.size(); ++size)
    EXPECT_THROW(decode_summary(summary.substr(0, size)), Error) << size;
  EXPECT_THROW(decode_face(face + "x"), Error);
  EXPECT_THROW(decode_summary(summary + "x"), Error);
  std::string huge = face;  // the number of knots
  for (std::size_t i = 8; i < 16; ++i) huge[i] = '\x7f';
  EXPECT_THROW(decode_face(huge), Error);
}

TEST(CadStream, damagedBytesGiveAValidFaceOrAnError) {
  const std::string good = encode(trimmed_tube());
  Random random(8);
  std::size_t refused = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string bytes = good;
    for (std::size_t k = 0; k <= random.below(3); ++k)
      bytes[random.below(bytes.size())] = static_cast<char>(random.below(256));
    try {
      validate(decode_face(bytes));
    } catch (const Error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 100u);
}

void expect_bad(const std::vector<std::string>& command, const std::string& why,
                double seconds = 0) {
  try {
    read_cad_file_guarded(name, {command, seconds, 0});
    ADD_FAILURE() << command.front() << " was believed";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find(why), std::string::npos) << error.what();
  }
}

TEST(CadGuard, childrenThatDieOrHangAreInputErrors) {
  expect_bad({"sh", "-c", "exit 0"}, "crashes");
  expect_bad({"sh", "-c", "kill -SEGV $$"}, "crashes");
  expect_bad({"sh", "-c", "printf abc"}, "crashes");
  expect_bad({"sh", "-c", "kill -XCPU $$"}, "more than 20 seconds");
  expect_bad({"sleep", "60", ";"}, "crashes");  // wrong usage
  expect_bad({"sh", "-c", "exec sleep 60"}, "more than", 0.1);
}

TEST(CadGuard, saysIfItCannotBegin) {
  EXPECT_THROW(read_cad_file_guarded(name, {}), UsageError);
  try {
    read_cad_file_guarded(name, {{"/nowhere/program"}, 0, 0});
    ADD_FAILURE();
  } catch (const InputError& error) {
    ADD_FAILURE() << "the file was blamed: " << error.what();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("/nowhere/program"), std::string::npos);
  }
}

TEST(CadGuard, isCancelledWhileItWaits) {
  std::stop_source stop;
  stop.request_stop();
  Job job;
  job.stop = stop.get_token();
  EXPECT_THROW(read_cad_file_guarded(name, {{"sh", "-c", "exec sleep 60"}, 0, 0}, job), Cancelled);
}

TEST(CadGuard, serverRefusesOtherArguments) {
  EXPECT_EQ(serve_cad_file({}), 2);
  EXPECT_EQ(serve_cad_file(std::vector<std::string>{"0", "0", name}), 2);
}

}  // namespace
}  // namespace spigolo
