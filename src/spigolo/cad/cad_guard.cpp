// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/cad/cad_guard.cpp
#include "spigolo/cad/cad_guard.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <memory>
#include <mutex>
#include <utility>

#include "spigolo/cad/cad_stream.h"
#include "spigolo/core/error.h"

extern char** environ;

namespace spigolo {
namespace {

constexpr double usual_seconds = 20, seconds_per_megabyte = 10;
constexpr std::uint64_t usual_memory = 4'000'000'000, memory_per_byte = 1000;
constexpr double patience = 6;  // seconds that may pass for each second of processor
constexpr int glance = 100;     // [ms] between looks at the stop token
constexpr std::size_t piece = std::size_t{1} << 16;

// 0 if there is none: the child will say so.
std::uint64_t size_of(const std::filesystem::path& path) {
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  return error ? 0 : size;
}

double seconds_for(const std::filesystem::path& path, const CadGuard& guard) {
  if (guard.seconds > 0) return guard.seconds;
  return usual_seconds + seconds_per_megabyte * static_cast<double>(size_of(path)) / 1e6;
}

std::uint64_t memory_for(const std::filesystem::path& path, const CadGuard& guard) {
  return guard.memory > 0 ? guard.memory : usual_memory + memory_per_byte * size_of(path);
}

// A child with one socket at its standard input and output, silent on standard error, and in a
// group of its own: Ctrl-C is for the parent.
class Child {
 public:
  Child(std::vector<std::string> words, double seconds) : seconds_(seconds), name_(words.front()) {
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) refuse();
    socket_ = ends[0];
    const int problem = start(std::move(words), ends[1]);
    ::close(ends[1]);
    if (problem != 0) {
      ::close(socket_);
      refuse();
    }
  }
  ~Child() {
    ::close(socket_);
    reap();
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  void ask(std::uint64_t face) {  // a dead child shows when the answer does not come
    [[maybe_unused]] const auto sent = ::send(socket_, &face, sizeof face, MSG_NOSIGNAL);
  }

  enum class Ending : std::uint8_t { none, crash, too_long };

  /// Reads `size` bytes.
  Ending receive(std::uint64_t size, std::string& bytes, const Job& job) {
    const auto until = Clock::now() + std::chrono::duration<double>(patience * seconds_);
    std::array<char, piece> buffer{};
    while (size > 0) {
      job.check();
      if (Clock::now() > until) return Ending::too_long;
      pollfd here{socket_, POLLIN, 0};
      if (::poll(&here, 1, glance) <= 0) continue;
      const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(size, piece));
      const ssize_t got = ::recv(socket_, buffer.data(), wanted, 0);
      if (got <= 0) return reap();
      bytes.append(buffer.data(), static_cast<std::size_t>(got));
      size -= static_cast<std::uint64_t>(got);
    }
    return Ending::none;
  }
  double seconds() const { return seconds_; }

 private:
  using Clock = std::chrono::steady_clock;

  [[noreturn]] void refuse() const {
    throw Error(name_ + ", which reads CAD files, cannot be started");
  }

  int start(std::vector<std::string> words, int socket) {
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_adddup2(&actions, socket, STDIN_FILENO);
    ::posix_spawn_file_actions_adddup2(&actions, socket, STDOUT_FILENO);
    ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawnattr_t attributes;
    ::posix_spawnattr_init(&attributes);
    sigset_t none;
    ::sigemptyset(&none);
    ::posix_spawnattr_setsigmask(&attributes, &none);
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
    const int problem = ::posix_spawnp(&pid_, argv[0], &actions, &attributes, argv.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    ::posix_spawnattr_destroy(&attributes);
    if (problem != 0) pid_ = -1;
    return problem;
  }

  Ending reap() {
    if (pid_ <= 0) return Ending::crash;
    int status = 0;
    ::kill(pid_, SIGKILL);  // nothing to one that is ending already
    ::waitpid(std::exchange(pid_, -1), &status, 0);
    return WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU ? Ending::too_long : Ending::crash;
  }

  double seconds_;
  std::string name_;
  pid_t pid_ = -1;
  int socket_ = -1;
};

[[noreturn]] void report(Child::Ending ending, const std::string& path, double seconds) {
  if (ending == Child::Ending::too_long)
    throw InputError(path, "",
                     "is damaged, or far too large: reading it took more than " +
                         std::to_string(std::lround(seconds)) + " seconds; export it again");
  throw InputError(path, "", "is damaged: the reader crashes on it; export it again");
}

// "FILE, PLACE: PROBLEM" or "FILE: PROBLEM", as the child's error says it.
InputError input_error(const std::string& message, const std::string& path) {
  const std::string rest = message.starts_with(path) ? message.substr(path.size()) : ": " + message;
  const std::size_t colon = rest.find(": ");
  if (colon == std::string::npos) return {path, "", rest};
  return {path, colon < 2 ? "" : rest.substr(2, colon - 2), rest.substr(colon + 2)};
}

// The child's own exceptions are thrown again here.
[[noreturn]] void rethrow(CadAnswer kind, const std::string& message, const std::string& path) {
  switch (kind) {
    case CadAnswer::input_error:
      throw input_error(message, path);
    case CadAnswer::no_result:
      throw NoResultError(message);
    case CadAnswer::usage_error:
      throw UsageError(message);
    case CadAnswer::out_of_memory:
      throw MemoryError(path +
                        ": reading it needs more memory than is allowed; the file is "
                        "damaged, or more must be allowed");
    default:
      throw Error(path + ": cannot be read: " + message);
  }
}

// The file as its child knows it; one question at a time.
class GuardedFile {
 public:
  GuardedFile(const std::string& path, std::vector<std::string> words, double seconds)
      : path_(path), child_(std::move(words), seconds) {}

  std::string answer(const Job& job) {
    std::string bytes;
    CadAnswer kind{};
    std::uint64_t size = 0;
    receive(sizeof kind, bytes, job).copy(reinterpret_cast<char*>(&kind), sizeof kind);
    receive(sizeof size, bytes, job).copy(reinterpret_cast<char*>(&size), sizeof size);
    receive(size, bytes, job);
    if (kind != CadAnswer::done) rethrow(kind, bytes, path_);
    return bytes;
  }
  std::string face(std::size_t i) {
    const std::lock_guard lock(one_at_a_time_);
    child_.ask(i);
    return answer({});
  }

 private:
  const std::string& receive(std::uint64_t size, std::string& bytes, const Job& job) {
    bytes.clear();
    const Child::Ending ending = child_.receive(size, bytes, job);
    if (ending != Child::Ending::none) report(ending, path_, child_.seconds());
    return bytes;
  }

  std::string path_;
  std::mutex one_at_a_time_;
  Child child_;
};

}  // namespace

CadFile read_cad_file_guarded(const std::filesystem::path& path, const CadGuard& guard,
                              const Job& job) {
  if (guard.command.empty()) throw UsageError("a guard needs a command that reads CAD files");
  const double seconds = seconds_for(path, guard);
  std::vector<std::string> words = guard.command;
  words.push_back(std::to_string(seconds));
  words.push_back(std::to_string(memory_for(path, guard)));
  words.push_back(path.string());
  const auto file = std::make_shared<GuardedFile>(path.string(), std::move(words), seconds);
  CadSummary summary = decode_summary(file->answer(job));
  return {std::move(summary), [file](std::size_t i) { return decode_face(file->face(i)); }};
}

}  // namespace spigolo
