// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/rival.cpp
#include "rival.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>

#include <cstdio>
#include <fstream>
#include <sstream>

extern char** environ;

namespace spigolo::bench {
namespace {

constexpr const char* longest_run = "1800";  // seconds

int wait_for(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// All numbers of a line; "nan" counts as 0.
std::vector<double> numbers_of(const std::string& line) {
  std::vector<double> numbers;
  const char* at = line.c_str();
  for (char* end = nullptr;; at = end) {
    const double value = std::strtod(at, &end);
    if (end == at) return numbers;
    numbers.push_back(std::isfinite(value) ? value : 0);
  }
}

}  // namespace

int run_status(const RivalPlaces& places, const std::vector<std::string>& command) {
  fs::create_directories(places.scratch);
  std::vector<std::string> words = {"timeout", longest_run};
  words.insert(words.end(), command.begin(), command.end());
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  const std::string log = places.file("rivals.log").string();
  posix_spawn_file_actions_addopen(&actions, 1, log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
  posix_spawn_file_actions_adddup2(&actions, 1, 2);
  pid_t child = 0;
  const int failed =
      posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return failed == 0 ? wait_for(child) : -1;
}

bool run_rival(const RivalPlaces& places, const std::vector<std::string>& command) {
  return run_status(places, command) == 0;
}

std::string package_version(const RivalPlaces& places, const std::string& package) {
  const fs::path log = places.file("rivals.log");
  fs::remove(log);
  if (!run_rival(places, {"dpkg-query", "-W", "-f", "${Version}", package})) return "not installed";
  std::ifstream in(log);
  std::string version;
  in >> version;
  return version;
}

void write_xyz(const fs::path& path, const std::vector<Vec3>& points,
               const std::vector<Vec3>& normals) {
  fs::create_directories(path.parent_path());
  std::FILE* out = std::fopen(path.c_str(), "w");
  if (out == nullptr) throw fs::filesystem_error("cannot write", path, std::error_code());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3& p = points[i];
    std::fprintf(out, "%.17g %.17g %.17g", p.x, p.y, p.z);
    if (!normals.empty())
      std::fprintf(out, " %.17g %.17g %.17g", normals[i].x, normals[i].y, normals[i].z);
    std::fputc('\n', out);
  }
  std::fclose(out);
}

std::optional<OrientedPoints> read_xyz(const fs::path& path) {
  std::ifstream in(path);
  if (!in) return std::nullopt;
  OrientedPoints result;
  for (std::string line; std::getline(in, line);) {
    const std::vector<double> n = numbers_of(line);
    if (n.size() < 3) continue;
    result.points.push_back({n[0], n[1], n[2]});
    result.normals.push_back(n.size() < 6 ? Vec3{} : Vec3{n[3], n[4], n[5]});
  }
  return result;
}

std::optional<Scores> read_scores(const fs::path& path, std::size_t skip, std::size_t take) {
  std::ifstream in(path);
  std::string line;
  if (!in || !std::getline(in, line)) return std::nullopt;
  Scores scores;
  std::istringstream head(line);
  std::size_t column = 0;
  for (std::string name; head >> name; ++column)
    if (column >= skip && column < skip + take) scores.names.push_back(name);
  scores.columns.resize(scores.names.size());
  while (std::getline(in, line)) {
    const std::vector<double> n = numbers_of(line);
    if (n.size() < skip + scores.names.size()) return std::nullopt;
    for (std::size_t c = 0; c < scores.names.size(); ++c) scores.columns[c].push_back(n[skip + c]);
  }
  return scores;
}

}  // namespace spigolo::bench
