// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/text.h - lines, words and numbers of text files, the same under every locale
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "spigolo/core/point_cloud.h"
#include "spigolo/io/input_bytes.h"

namespace spigolo {

/// Reads the number at p, moves p behind it, and leaves both alone and returns false if there is
/// none or it is too large for a double. Takes a leading +, nan, inf and what old Windows programs
/// write for them (1.#QNAN, 1.#INF).
bool parse_number(const char*& p, const char* end, double& value);
/// The same for float, rounded once.
bool parse_number(const char*& p, const char* end, float& value);

/// The whole word as a count; false for anything else.
bool parse_count(std::string_view word, std::uint64_t& value);

/// Appends the shortest text that reads back to the same value of that type.
void append_number(std::string& out, double value, ScalarType type);

constexpr bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/// Cuts the next blank-separated word off the front of `line`; empty at its end.
std::string_view next_word(std::string_view& line);

/// `text` with A-Z made small.
std::string lower(std::string_view text);

/// A short piece of the text for a message, without control characters.
std::string excerpt(std::string_view text);

/// The lines of a text. Ends at "\n", "\r\n", or "\r" if there is no "\n" at all; a byte order mark
/// is skipped.
class LineReader {
 public:
  /// Throws InputError if the bytes are no text: a NUL near the start, or UTF-16.
  explicit LineReader(const InputBytes& input);

  /// The next line without its end; false after the last one.
  bool next(std::string_view& line);
  /// The next line with a word in it, cut at `comment`; false after the last one.
  bool next_content(std::string_view& line, char comment = '#');
  /// Number of the last line read, from 1.
  std::size_t number() const { return number_; }
  /// Bytes not yet read.
  std::size_t rest() const { return static_cast<std::size_t>(end_ - p_); }
  /// Throws InputError at the last line read.
  [[noreturn]] void fail(const std::string& problem) const;

 private:
  std::string name_;
  const char* p_;
  const char* end_;
  char line_end_ = '\n';
  std::size_t number_ = 0;
};

/// The blank-separated words of a text, whatever lines they stand on.
class WordReader {
 public:
  /// first_line: the number of the line that `text` begins with.
  WordReader(std::string name, std::string_view text, std::size_t first_line)
      : name_(std::move(name)), p_(text.data()), end_(p_ + text.size()), line_(first_line) {}

  /// The next word; throws InputError "the file is cut off" after the last one.
  std::string_view word();
  /// The next word as a number of that type (floats rounded once); throws InputError if it is none.
  double number(ScalarType type);
  /// The next word as a list length; throws InputError if it is none.
  std::uint64_t count();
  bool at_end();
  std::size_t rest() const { return static_cast<std::size_t>(end_ - p_); }
  [[noreturn]] void fail(const std::string& problem) const;

 private:
  void skip_blanks();

  std::string name_;
  const char* p_;
  const char* end_;
  std::size_t line_;
};

}  // namespace spigolo
