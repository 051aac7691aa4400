// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/input_bytes.h - the whole of one input in memory, and the name to blame in messages
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace spigolo {

/// What every reader takes: bytes that somebody else keeps alive.
struct InputBytes {
  std::string name;  // as messages show it
  std::span<const std::byte> bytes;

  std::size_t size() const { return bytes.size(); }
  std::string_view text() const {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }
};

/// Owns the bytes of a file. They are read, not mapped: a file that is cut while it is in use then
/// means an error and not a dead process.
class FileBytes {
 public:
  /// Reads the whole file; "-" is standard input, to its end.
  /// Throws InputError if it is missing, a folder, unreadable or empty; MemoryError if too large.
  explicit FileBytes(const std::filesystem::path& path);

  InputBytes view() const { return {name_, {data_.get(), size_}}; }

 private:
  void read_all(int descriptor, std::size_t expected);

  std::string name_;
  std::unique_ptr<std::byte[]> data_;
  std::size_t size_ = 0;
};

}  // namespace spigolo
