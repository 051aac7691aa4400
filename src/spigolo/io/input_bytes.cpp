// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/input_bytes.cpp
#include "spigolo/io/input_bytes.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>
#include <system_error>

#include "spigolo/core/error.h"

namespace spigolo {
namespace {

constexpr std::size_t longest_read = std::size_t{1} << 30;  // Linux reads 2 GiB at most in one call
constexpr std::size_t pipe_start = std::size_t{1} << 16;

// Closes on every way out.
struct Descriptor {
  int number;
  ~Descriptor() {
    if (number > STDERR_FILENO) ::close(number);
  }
};

int open_for_reading(const std::string& name) {
  const int descriptor = ::open(name.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor >= 0) return descriptor;
  const int reason = errno;
  if (reason == ENOENT)
    throw InputError(name, "", "there is no such file; check the path and the spelling");
  if (reason == EACCES)
    throw InputError(name, "", "permission denied; make the file readable (chmod +r)");
  throw InputError(name, "", "cannot be opened: " + std::generic_category().message(reason));
}

std::unique_ptr<std::byte[]> allocate(const std::string& name, std::size_t size) {
  try {
    return std::make_unique_for_overwrite<std::byte[]>(size);
  } catch (const std::bad_alloc&) {
    throw MemoryError(name + ": the file of " + std::to_string(size) +
                      " bytes does not fit into memory; cut it into parts");
  }
}

}  // namespace

FileBytes::FileBytes(const std::filesystem::path& path)
    : name_(path == "-" ? "standard input" : path.string()) {
  const Descriptor file{path == "-" ? STDIN_FILENO : open_for_reading(name_)};
  struct stat status {};
  if (::fstat(file.number, &status) != 0)
    throw InputError(name_, "", "cannot be read: " + std::generic_category().message(errno));
  if (S_ISDIR(status.st_mode)) throw InputError(name_, "", "is a folder; name a file in it");
  const bool regular = S_ISREG(status.st_mode) && status.st_size > 0;
  read_all(file.number, regular ? static_cast<std::size_t>(status.st_size) : pipe_start);
  if (size_ == 0) throw InputError(name_, "byte 0", "the file is empty; check how it was written");
}

// Doubles the room when more comes than expected: a pipe does not tell its length.
void FileBytes::read_all(int descriptor, std::size_t expected) {
  std::size_t room = expected + 1;  // one more, so that the end shows without another allocation
  data_ = allocate(name_, room);
  while (true) {
    if (size_ == room) {
      auto larger = allocate(name_, room * 2);
      std::memcpy(larger.get(), data_.get(), size_);
      data_ = std::move(larger);
      room *= 2;
    }
    const ssize_t got =
        ::read(descriptor, data_.get() + size_, std::min(room - size_, longest_read));
    if (got == 0) return;
    if (got > 0) size_ += static_cast<std::size_t>(got);
    if (got < 0 && errno != EINTR)
      throw InputError(name_, "byte " + std::to_string(size_),
                       "reading failed: " + std::generic_category().message(errno));
  }
}

}  // namespace spigolo
