// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/apps/program.h - runs the built program as a shell would
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "spigolo/core/point_cloud.h"

namespace spigolo::test {

using Json = nlohmann::ordered_json;

struct Outcome {
  int status = -1;  // exit status; 128 + signal if a signal ended it
  std::string out, err;

  Json json() const { return Json::parse(out); }
};

/// A running program with pipes at its three streams; killed if it still runs at the end.
class Program {
 public:
  explicit Program(const std::vector<std::string>& arguments);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  /// Waits until something has been written to stderr.
  void wait_for_message();
  void send(int signal) const;
  /// Feeds `input`, closes stdin and reads both outputs to their ends.
  Outcome finish(const std::string& input = "");

 private:
  void exchange(std::string input);
  bool read_some(int& descriptor, std::string& to);

  int pid_ = -1;
  int in_ = -1, out_ = -1, err_ = -1;
  Outcome outcome_;
};

/// Runs it to its end.
Outcome run_program(const std::vector<std::string>& arguments, const std::string& input = "");

/// Every test gets an empty folder of its own.
class ProgramTest : public ::testing::Test {
 protected:
  ProgramTest();
  ~ProgramTest() override;

  /// The path of a file in the folder.
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  /// Writes a file there and gives its path.
  std::string file(const std::string& name, const std::string& content) const;
  std::string cloud_file(const std::string& name, const PointCloud& cloud) const;
  /// Names of all files there, sorted; hidden ones too.
  std::vector<std::string> listing() const;

 private:
  std::filesystem::path folder_;
};

std::string content_of(const std::string& path);

/// The thesis's cube, as points alone: 10088 of them.
PointCloud small_cube();

/// One value per point; fails the test if there is no such attribute.
std::vector<double> values_of(const PointCloud& cloud, const std::string& name);

}  // namespace spigolo::test
