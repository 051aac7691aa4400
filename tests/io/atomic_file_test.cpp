// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/io/atomic_file_test.cpp - an output appears whole or not at all
#include "support.h"

#include <sys/stat.h>

#include "spigolo/io/atomic_file.h"

namespace spigolo {
namespace {

TEST(AtomicFile, AppearsOnCommitOnly) {
  const TempFolder folder;
  AtomicFile out(folder / "a.txt");
  out.write("new");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.txt"));
  out.commit();
  EXPECT_EQ(read_file(folder / "a.txt"), "new");
  EXPECT_EQ(folder.count(), 1u);
}

TEST(AtomicFile, WithoutCommitTheOlderFileStaysAndNothingElse) {
  const TempFolder folder;
  write_file(folder / "a.txt", "old");
  try {
    AtomicFile out(folder / "a.txt");
    out.write(std::string(3000000, 'x'));
    throw Cancelled();
  } catch (const Cancelled&) {
  }
  EXPECT_EQ(read_file(folder / "a.txt"), "old");
  EXPECT_EQ(folder.count(), 1u);
}

TEST(AtomicFile, AFailingWriterLeavesTheOlderFile) {
  const TempFolder folder;
  write_file(folder / "a.las", "old");
  write_file(folder / "a.stl", "old");
  PointCloud cloud;
  cloud.points = {{not_a_number, 0, 0}};
  EXPECT_THROW(write_cloud(folder / "a.las", cloud), UsageError);
  EXPECT_THROW(write_mesh(folder / "a.stl", {cloud, {}}), UsageError);
  EXPECT_EQ(read_file(folder / "a.las"), "old");
  EXPECT_EQ(read_file(folder / "a.stl"), "old");
  EXPECT_EQ(folder.count(), 2u);
}

TEST(AtomicFile, MovesWithItsTemporary) {
  const TempFolder folder;
  std::vector<AtomicFile> several;
  for (int i = 0; i < 5; ++i) several.emplace_back(folder / (std::to_string(i) + ".txt"));
  for (AtomicFile& out : several) out.write("x");
  for (AtomicFile& out : several) out.commit();
  several.clear();
  EXPECT_EQ(folder.count(), 5u);
}

TEST(AtomicFile, KeepsTheModeAndFollowsLinks) {
  const TempFolder folder;
  write_file(folder / "real.txt", "old");
  ::chmod((folder / "real.txt").c_str(), 0640);
  std::filesystem::create_symlink("real.txt", folder / "link.txt");
  AtomicFile out(folder / "link.txt");
  out.write("new");
  out.commit();
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.txt"));
  EXPECT_EQ(read_file(folder / "real.txt"), "new");
  struct stat status {};
  ::stat((folder / "real.txt").c_str(), &status);
  EXPECT_EQ(status.st_mode & 0777u, 0640u);
}

TEST(AtomicFile, WhatCannotBeWrittenIsRefusedEarly) {
  const TempFolder folder;
  const auto refusal = [](const std::filesystem::path& path) {
    return message_of<UsageError>([&] { check_writable(path); });
  };
  EXPECT_TRUE(has(refusal(folder / "no/such/a.ply"), "no/such/a.ply: cannot be written"));
  EXPECT_TRUE(has(refusal(folder / "no/such/a.ply"), "mkdir -p"));
  EXPECT_TRUE(has(refusal(folder / ""), "it is a folder"));
  EXPECT_TRUE(has(refusal(""), "cannot be written"));
  EXPECT_TRUE(has(refusal("/proc/a.ply"), "/proc/a.ply"));
  EXPECT_EQ(folder.count(), 0u);
}

TEST(AtomicFile, CheckingLeavesNothingBehind) {
  const TempFolder folder;
  write_file(folder / "a.ply", "old");
  check_writable(folder / "a.ply");
  check_writable(folder / "b.ply");
  check_writable("-");
  ::mkfifo((folder / "pipe").c_str(), 0600);
  check_writable(folder / "pipe");  // without waiting for a reader
  EXPECT_EQ(folder.count(), 2u);
  EXPECT_EQ(read_file(folder / "a.ply"), "old");
}

TEST(AtomicFile, DevicesAreWrittenAndStay) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  AtomicFile nothing("/dev/null");
  nothing.write("x");
  nothing.commit();
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
  const std::string full = message_of<Error>([] {
    AtomicFile out("/dev/full");
    out.write("x");
    out.commit();
  });
  EXPECT_TRUE(has(full, "/dev/full: writing failed")) << full;
  EXPECT_TRUE(has(full, "make room"));
}

}  // namespace
}  // namespace spigolo
