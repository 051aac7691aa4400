// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/io/pipe_test.cpp - standard input and output
#include <fcntl.h>
#include <sys/wait.h>

#include "support.h"

namespace spigolo {
namespace {

// Puts another descriptor in the place of standard input or output, for its lifetime.
class Redirected {
 public:
  Redirected(int standard, int replacement) : standard_(standard), saved_(::dup(standard)) {
    ::dup2(replacement, standard);
    ::close(replacement);
  }
  Redirected(const Redirected&) = delete;
  ~Redirected() {
    ::dup2(saved_, standard_);
    ::close(saved_);
  }

 private:
  int standard_, saved_;
};

// Reads "-" while another process writes the content into a pipe, piece by piece.
PointCloud read_piped(const std::string& content, ReadReport* report = nullptr) {
  int ends[2];
  EXPECT_EQ(::pipe(ends), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(ends[0]);
    std::string_view rest = content;
    while (!rest.empty()) {
      const ssize_t n = ::write(ends[1], rest.data(), std::min<std::size_t>(rest.size(), 5000));
      if (n <= 0) ::_exit(1);
      rest.remove_prefix(static_cast<std::size_t>(n));
    }
    ::_exit(0);
  }
  ::close(ends[1]);
  const Redirected input(STDIN_FILENO, ends[0]);
  PointCloud cloud = read_cloud("-", report);
  ::waitpid(child, nullptr, 0);
  return cloud;
}

TEST(Pipe, StandardInputIsPlyOrATable) {
  const TempFolder folder;
  const PointCloud cloud = survey_cloud(20000, 1);  // more than a pipe holds at once
  ReadReport report;
  for (const char* name : {"a.ply", "a.xyz", "a.csv"}) {
    write_cloud(folder / name, cloud);
    expect_same(cloud, read_piped(read_file(folder / name), &report));
    EXPECT_EQ(report.format, name == std::string("a.ply") ? "ply" : "text");
  }
}

TEST(Pipe, EmptyStandardInputIsNamed) {
  const std::string what = message_of<InputError>([] { read_piped(""); });
  EXPECT_TRUE(has(what, "standard input, byte 0: the file is empty")) << what;
}

TEST(Pipe, StandardOutputTakesEitherFormat) {
  const TempFolder folder;
  const PointCloud cloud = survey_cloud(1000, 2);
  for (const FileFormat format : {FileFormat::xyz, FileFormat::ply}) {
    const auto path = folder / "out";
    {
      const Redirected output(STDOUT_FILENO,
                              ::open(path.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600));
      AtomicFile out("-");
      write_cloud(out, format, cloud);
      out.commit();
    }
    const std::string text = read_file(path);
    expect_same(cloud, read_cloud(as_input(text), format));
  }
}

}  // namespace
}  // namespace spigolo
