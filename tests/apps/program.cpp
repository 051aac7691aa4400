// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/apps/program.cpp
#include "apps/program.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <utility>

#include "spigolo/io/cloud_file.h"
#include "spigolo/synth/synth.h"

extern char** environ;

namespace spigolo::test {
namespace {

struct Pipe {
  int read = -1, write = -1;
};

Pipe make_pipe() {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
  return {ends[0], ends[1]};
}

void close_end(int& descriptor) {
  if (descriptor >= 0) ::close(std::exchange(descriptor, -1));
}

}  // namespace

Program::Program(const std::vector<std::string>& arguments) {
  ::signal(SIGPIPE, SIG_IGN);  // a child may end before it has read all
  Pipe in = make_pipe(), out = make_pipe(), err = make_pipe();
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, in.read, STDIN_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, out.write, STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, err.write, STDERR_FILENO);

  // As a shell starts it, whatever this process ignores.
  sigset_t signals;
  ::sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM, SIGPIPE}) ::sigaddset(&signals, signal);
  posix_spawnattr_t attributes;
  ::posix_spawnattr_init(&attributes);
  ::posix_spawnattr_setsigdefault(&attributes, &signals);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);

  std::string program = SPIGOLO_PROGRAM;
  std::vector<std::string> words = arguments;
  std::vector<char*> argv = {program.data()};
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const int problem =
      ::posix_spawn(&pid_, program.c_str(), &actions, &attributes, argv.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  ::posix_spawnattr_destroy(&attributes);
  close_end(in.read), close_end(out.write), close_end(err.write);
  in_ = in.write, out_ = out.read, err_ = err.read;
  if (problem != 0) throw std::runtime_error("cannot start " + program);
}

Program::~Program() {
  close_end(in_), close_end(out_), close_end(err_);
  if (pid_ <= 0) return;
  ::kill(pid_, SIGKILL);
  ::waitpid(pid_, nullptr, 0);
}

void Program::send(int signal) const { ::kill(pid_, signal); }

void Program::wait_for_message() {
  while (outcome_.err.empty() && read_some(err_, outcome_.err)) {
  }
}

bool Program::read_some(int& descriptor, std::string& to) {
  std::array<char, 65536> buffer{};
  const ssize_t got = ::read(descriptor, buffer.data(), buffer.size());
  if (got <= 0) return close_end(descriptor), false;
  to.append(buffer.data(), static_cast<std::size_t>(got));
  return true;
}

// Feeds and reads at once: a full pipe on either side would stop both.
void Program::exchange(std::string input) {
  ::fcntl(in_, F_SETFL, O_NONBLOCK);
  while (in_ >= 0 || out_ >= 0 || err_ >= 0) {
    if (input.empty()) close_end(in_);
    std::array<pollfd, 3> ends = {{{in_, POLLOUT, 0}, {out_, POLLIN, 0}, {err_, POLLIN, 0}}};
    if (::poll(ends.data(), ends.size(), -1) < 0) throw std::runtime_error("poll failed");
    if (ends[0].revents != 0) {
      const ssize_t fed = ::write(in_, input.data(), input.size());
      input.erase(0, fed < 0 ? input.size() : static_cast<std::size_t>(fed));
    }
    if (ends[1].revents != 0) read_some(out_, outcome_.out);
    if (ends[2].revents != 0) read_some(err_, outcome_.err);
  }
}

Outcome Program::finish(const std::string& input) {
  exchange(input);
  int status = 0;
  ::waitpid(std::exchange(pid_, -1), &status, 0);
  outcome_.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return std::move(outcome_);
}

Outcome run_program(const std::vector<std::string>& arguments, const std::string& input) {
  return Program(arguments).finish(input);
}

ProgramTest::ProgramTest() {
  std::string name = std::filesystem::temp_directory_path() / "spigolo_test_XXXXXX";
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  folder_ = name;
}

ProgramTest::~ProgramTest() { std::filesystem::remove_all(folder_); }

std::string ProgramTest::file(const std::string& name, const std::string& content) const {
  std::ofstream(path(name), std::ios::binary) << content;
  return path(name);
}

std::string ProgramTest::cloud_file(const std::string& name, const PointCloud& cloud) const {
  write_cloud(path(name), cloud);
  return path(name);
}

std::vector<std::string> ProgramTest::listing() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder_))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string content_of(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

PointCloud small_cube() { return {make_cloud({}).cloud.points, {}}; }

std::vector<double> values_of(const PointCloud& cloud, const std::string& name) {
  const Attribute* found = cloud.find(name);
  EXPECT_NE(found, nullptr) << name;
  return found == nullptr ? std::vector<double>(cloud.size()) : found->values;
}

}  // namespace spigolo::test
