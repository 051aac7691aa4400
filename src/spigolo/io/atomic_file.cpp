// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/atomic_file.cpp
#include "spigolo/io/atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "spigolo/core/error.h"

namespace spigolo {
namespace {

constexpr std::size_t buffer_size = std::size_t{1} << 20;
constexpr mode_t permission_bits = 07777;
constexpr int name_tries = 1000;
constexpr std::size_t longest_stem = 200;  // names end at 255 bytes

std::string reason_text(int reason) { return std::generic_category().message(reason); }

[[noreturn]] void refuse(const std::string& name, int reason) {
  std::string remedy = "choose another folder";
  if (reason == ENOENT) remedy = "make the folder first (mkdir -p) or check the spelling";
  if (reason == EACCES || reason == EPERM) remedy = "choose a folder you may write to";
  if (reason == EISDIR) remedy = "it is a folder; name a file in it";
  if (reason == ENOSPC || reason == EDQUOT) remedy = "make room on the disk";
  throw UsageError(name + ": cannot be written (" + reason_text(reason) + "); " + remedy);
}

// The file a symbolic link leads to, also if that does not exist yet.
std::filesystem::path resolved(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::path target = path;
  for (int links = 0; links < 40 && std::filesystem::is_symlink(target, error); ++links) {
    const std::filesystem::path next = std::filesystem::read_symlink(target, error);
    if (error) return target;
    target = next.is_absolute() ? next : target.parent_path() / next;
  }
  return target;
}

}  // namespace

AtomicFile::AtomicFile(const std::filesystem::path& path)
    : name_(path == "-" ? "standard output" : path.string()), target_(resolved(path)) {
  if (path == "-") {
    descriptor_ = STDOUT_FILENO;
    return;
  }
  struct stat status {};
  const bool exists = ::stat(target_.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) refuse(name_, EISDIR);
  if (exists && ::access(target_.c_str(), W_OK) != 0) refuse(name_, errno);
  if (!exists && !target_.has_filename()) refuse(name_, EISDIR);
  if (exists && !S_ISREG(status.st_mode)) {
    descriptor_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) refuse(name_, errno);
    return;
  }
  open_beside_target();
  // Not every file system knows modes; the file is then as good as it can be.
  if (exists) static_cast<void>(::fchmod(descriptor_, status.st_mode & permission_bits));
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : name_(std::move(other.name_)),
      target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, {})),
      buffer_(std::move(other.buffer_)),
      descriptor_(std::exchange(other.descriptor_, -1)) {}

AtomicFile::~AtomicFile() {
  if (descriptor_ > STDERR_FILENO) ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void AtomicFile::open_beside_target() {
  std::string stem(1, '.');
  stem.append(target_.filename().string(), 0, longest_stem);
  stem += '.';
  stem += std::to_string(::getpid());
  stem += '.';
  for (int n = 0; n < name_tries; ++n) {
    const std::filesystem::path path = target_.parent_path() / (stem + std::to_string(n) + ".tmp");
    descriptor_ = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ >= 0) {
      temporary_ = path;
      return;
    }
    if (errno != EEXIST) refuse(name_, errno);
  }
  refuse(name_, EEXIST);
}

void AtomicFile::write(std::string_view bytes) {
  buffer_.append(bytes);
  if (buffer_.size() >= buffer_size) flush();
}

void AtomicFile::flush() {
  std::string_view rest = buffer_;
  while (!rest.empty()) {
    const ssize_t written = ::write(descriptor_, rest.data(), rest.size());
    if (written >= 0)
      rest.remove_prefix(static_cast<std::size_t>(written));
    else if (errno != EINTR)
      fail(errno);
  }
  buffer_.clear();
}

void AtomicFile::commit() {
  flush();
  if (temporary_.empty()) return;
  // Some file systems cannot flush one file and say EINVAL; that is no loss of data.
  if (::fsync(descriptor_) != 0 && errno != EINVAL && errno != ENOTSUP) fail(errno);
  if (::close(std::exchange(descriptor_, -1)) != 0) fail(errno);
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
  temporary_.clear();
}

void AtomicFile::fail(int reason) {
  const bool full = reason == ENOSPC || reason == EDQUOT || reason == EFBIG;
  throw Error(name_ + ": writing failed (" + reason_text(reason) + ")" +
              (full ? "; make room on the disk or choose another" : ""));
}

void commit_all(std::vector<AtomicFile>& files) {
  for (AtomicFile& file : files) file.flush();
  for (AtomicFile& file : files) file.commit();
}

void check_writable(const std::filesystem::path& path) {
  struct stat status {};
  // Opening a pipe would wait for its reader.
  if (path != "-" && ::stat(path.c_str(), &status) == 0 && S_ISFIFO(status.st_mode)) {
    if (::access(path.c_str(), W_OK) != 0) refuse(path.string(), errno);
    return;
  }
  const AtomicFile probe(path);
}

}  // namespace spigolo
