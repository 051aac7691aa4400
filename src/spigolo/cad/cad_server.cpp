// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/cad/cad_server.cpp - the process that OpenCASCADE may crash
#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdlib>
#include <memory>
#include <new>

#include "spigolo/cad/cad_guard.h"
#include "spigolo/cad/cad_stream.h"
#include "spigolo/core/error.h"

namespace spigolo {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool may_limit_memory = false;  // their shadows are terabytes of address space
#else
constexpr bool may_limit_memory = true;
#endif

bool write_all(int to, const void* data, std::size_t size) {
  const char* at = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t written = ::write(to, at, size);
    if (written <= 0) return false;
    at += written;
    size -= static_cast<std::size_t>(written);
  }
  return true;
}

bool answer(int to, CadAnswer kind, const std::string& bytes) {
  const auto size = static_cast<std::uint64_t>(bytes.size());
  return write_all(to, &kind, sizeof kind) && write_all(to, &size, sizeof size) &&
         write_all(to, bytes.data(), bytes.size());
}

// What `make` returns, or what it throws.
template <class Make>
bool answer_with(int to, const Make& make) {
  try {
    return answer(to, CadAnswer::done, make());
  } catch (const InputError& error) {
    return answer(to, CadAnswer::input_error, error.what());
  } catch (const NoResultError& error) {
    return answer(to, CadAnswer::no_result, error.what());
  } catch (const UsageError& error) {
    return answer(to, CadAnswer::usage_error, error.what());
  } catch (const std::bad_alloc&) {
    return answer(to, CadAnswer::out_of_memory, "");
  } catch (const std::exception& error) {
    return answer(to, CadAnswer::failed, error.what());
  }
}

void limit(int what, rlim_t most) {
  const rlimit both{most, most};
  ::setrlimit(static_cast<decltype(RLIMIT_CORE)>(what), &both);
}

// That many more seconds of processor from now on; the kernel ends what takes longer.
void limit_time(double seconds) {
  rusage used{};
  ::getrusage(RUSAGE_SELF, &used);
  const double total = static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) + seconds;
  const rlimit soft{static_cast<rlim_t>(total) + 1, RLIM_INFINITY};
  ::setrlimit(RLIMIT_CPU, &soft);
}

}  // namespace

int serve_cad_file(std::span<const std::string> arguments) {
  if (arguments.size() != 3) return 2;
  const double seconds = std::atof(arguments[0].c_str());
  const std::uint64_t memory = std::strtoull(arguments[1].c_str(), nullptr, 10);
  if (!(seconds > 0)) return 2;
  limit(RLIMIT_CORE, 0);
  if (memory > 0 && may_limit_memory) limit(RLIMIT_AS, memory);
  limit_time(seconds);

  // What libraries print must not come between the answers.
  const int out = ::dup(STDOUT_FILENO), nowhere = ::open("/dev/null", O_WRONLY);
  if (out < 0 || nowhere < 0 || ::dup2(nowhere, STDOUT_FILENO) < 0) return 1;
  std::unique_ptr<CadFile> file;
  const bool heard = answer_with(out, [&] {
    file = std::make_unique<CadFile>(arguments[2]);
    return encode(file->summary());
  });
  if (!heard || !file) return 0;
  for (std::uint64_t face = 0; ::read(STDIN_FILENO, &face, sizeof face) == sizeof face;) {
    limit_time(seconds);
    const auto make = [&] { return encode(file->face(static_cast<std::size_t>(face))); };
    if (!answer_with(out, make)) break;
  }
  return 0;
}

}  // namespace spigolo
