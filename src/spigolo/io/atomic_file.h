// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/atomic_file.h - an output appears whole or not at all
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace spigolo {

/// Writes to a temporary file beside the target and puts it in the target's place on commit().
/// Without commit() - an exception, a cancelled job - the destructor removes the temporary and an
/// older target stays as it was. The mode of an older file is kept, a symbolic link is followed.
/// "-" is standard output; it, devices and pipes are written directly.
class AtomicFile {
 public:
  /// Throws UsageError, with path and remedy, if the target cannot be written.
  explicit AtomicFile(const std::filesystem::path& path);
  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile& operator=(AtomicFile&&) = delete;
  ~AtomicFile();

  /// Appends. Throws Error if the disk is full or the reader of a pipe has gone.
  void write(std::string_view bytes);
  /// Flushes to the disk and renames; nothing may be written afterwards. Throws Error on failure.
  void commit();
  /// Hands over what was written so far: a full disk refuses it here, before anything is renamed.
  void flush();

 private:
  void open_beside_target();
  [[noreturn]] void fail(int reason);

  std::string name_;                 // as the user gave it
  std::filesystem::path target_;     // links resolved
  std::filesystem::path temporary_;  // empty when written directly
  std::string buffer_;
  int descriptor_ = -1;
};

/// All of them appear or, where the disk has no room for one, none.
void commit_all(std::vector<AtomicFile>& files);

/// Throws UsageError, with path and remedy, if an AtomicFile could not be made there; leaves
/// nothing behind. For asking before a long computation starts.
void check_writable(const std::filesystem::path& path);

}  // namespace spigolo
