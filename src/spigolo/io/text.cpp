// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/text.cpp
#include "spigolo/io/text.h"

#include <algorithm>
#include <charconv>
#include <cstring>

#include "spigolo/core/error.h"
#include "spigolo/io/scalar.h"

namespace spigolo {
namespace {

constexpr std::size_t binary_probe = 4096;  // bytes looked at to tell text from binary
constexpr std::size_t excerpt_length = 40;

// "1.#QNAN", "-1.#IND", "1.#INF": p stands on the '#'.
template <class T>
bool parse_windows_special(const char*& p, const char* end, T& value) {
  const char* q = p + 1;
  while (q != end && ((*q >= 'A' && *q <= 'Z') || (*q >= '0' && *q <= '9'))) ++q;
  const std::string_view word(p + 1, static_cast<std::size_t>(q - p - 1));
  if (word.substr(0, 3) == "INF")
    value = std::copysign(std::numeric_limits<T>::infinity(), value);
  else if (word.substr(0, 3) == "IND" || word.substr(0, 4) == "QNAN" || word.substr(0, 4) == "SNAN")
    value = std::numeric_limits<T>::quiet_NaN();
  else
    return false;
  p = q;
  return true;
}

template <class T>
bool parse(const char*& p, const char* end, T& value) {
  const char* q = p;
  if (q != end && *q == '+') {
    ++q;
    if (q != end && *q == '-') return false;
  }
  T parsed = 0;
  const auto [stop, error] = std::from_chars(q, end, parsed);
  if (error == std::errc::invalid_argument) return false;
  if (error == std::errc::result_out_of_range) {
    // Too small is zero, too large is no number we can keep.
    const std::string_view word(q, static_cast<std::size_t>(stop - q));
    if (word.find("e-") == word.npos && word.find("E-") == word.npos) return false;
  }
  const char* behind = stop;
  if (behind != end && *behind == '#' && !parse_windows_special(behind, end, parsed)) behind = stop;
  p = behind;
  value = parsed;
  return true;
}

template <class T>
void append(std::string& out, T value) {
  char buffer[40];
  if constexpr (std::is_floating_point_v<T>) {
    // The shortest text of 100000 is 1e+05: right, but not what people expect in a table.
    constexpr T plain = 1000000000;
    if (std::abs(value) < plain && value == std::trunc(value) &&
        !(value == 0 && std::signbit(value)))
      return append(out, static_cast<std::int64_t>(value));
  }
  const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
  out.append(buffer, result.ptr);
}

}  // namespace

bool parse_number(const char*& p, const char* end, double& value) { return parse(p, end, value); }
bool parse_number(const char*& p, const char* end, float& value) { return parse(p, end, value); }

bool parse_count(std::string_view word, std::uint64_t& value) {
  const char* end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  return error == std::errc{} && stop == end && !word.empty();
}

void append_number(std::string& out, double value, ScalarType type) {
  if (std::isnan(value) && !is_integer(type)) {
    out += "nan";
    return;
  }
  with_type(type, [&](auto tag) { append(out, narrow<decltype(tag)>(value)); });
}

std::string_view next_word(std::string_view& line) {
  std::size_t begin = 0;
  while (begin < line.size() && is_blank(line[begin])) ++begin;
  std::size_t end = begin;
  while (end < line.size() && !is_blank(line[end])) ++end;
  const std::string_view word = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return word;
}

std::string lower(std::string_view text) {
  std::string small(text);
  for (char& c : small)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return small;
}

std::string excerpt(std::string_view text) {
  std::string shown(text.substr(0, excerpt_length));
  for (char& c : shown)
    if (static_cast<unsigned char>(c) < ' ' || c == 127) c = '?';
  return text.size() > excerpt_length ? shown + "..." : shown;
}

LineReader::LineReader(const InputBytes& input)
    : name_(input.name), p_(input.text().data()), end_(p_ + input.size()) {
  std::string_view text = input.text();
  if (text.substr(0, 2) == "\xff\xfe" || text.substr(0, 2) == "\xfe\xff")
    throw InputError(name_, "byte 0", "the text is UTF-16; save it as UTF-8 or ASCII");
  const std::size_t zero = text.substr(0, binary_probe).find('\0');
  if (zero != text.npos)
    throw InputError(name_, "byte " + std::to_string(zero),
                     "binary data where text is expected; give the file the ending of its format");
  if (text.substr(0, 3) == "\xef\xbb\xbf") p_ += 3;
  if (text.find('\n') == text.npos && text.find('\r') != text.npos) line_end_ = '\r';
}

bool LineReader::next(std::string_view& line) {
  if (p_ == end_) return false;
  const auto* stop = static_cast<const char*>(std::memchr(p_, line_end_, rest()));
  if (stop == nullptr) stop = end_;
  line = {p_, static_cast<std::size_t>(stop - p_)};
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  p_ = stop == end_ ? end_ : stop + 1;
  ++number_;
  return true;
}

bool LineReader::next_content(std::string_view& line, char comment) {
  while (next(line)) {
    line = line.substr(0, line.find(comment));
    if (!std::all_of(line.begin(), line.end(), is_blank)) return true;
  }
  return false;
}

void LineReader::fail(const std::string& problem) const {
  throw InputError(name_, "line " + std::to_string(number_), problem);
}

void WordReader::skip_blanks() {
  for (; p_ != end_ && (is_blank(*p_) || *p_ == '\n'); ++p_) line_ += *p_ == '\n';
}

bool WordReader::at_end() {
  skip_blanks();
  return p_ == end_;
}

std::string_view WordReader::word() {
  if (at_end()) fail("the file is cut off here; fetch it again or export it anew");
  const char* begin = p_;
  while (p_ != end_ && !is_blank(*p_) && *p_ != '\n') ++p_;
  return {begin, static_cast<std::size_t>(p_ - begin)};
}

double WordReader::number(ScalarType type) {
  if (at_end()) fail("the file is cut off here; fetch it again or export it anew");
  const char* begin = p_;
  double value = 0;
  float single = 0;
  bool sound = false;
  if (type == ScalarType::float32 && parse_number(p_, end_, single)) {
    value = static_cast<double>(single);
    sound = true;
  } else {
    sound = parse_number(p_, end_, value);
  }
  if (sound && (p_ == end_ || is_blank(*p_) || *p_ == '\n')) return value;
  p_ = begin;
  fail("'" + excerpt(word()) + "' is not a number; the file is damaged or not what it claims");
}

std::uint64_t WordReader::count() {
  const std::string_view text = word();
  std::uint64_t value = 0;
  if (!parse_count(text, value)) fail("'" + excerpt(text) + "' is not a list length");
  return value;
}

void WordReader::fail(const std::string& problem) const {
  throw InputError(name_, "line " + std::to_string(line_), problem);
}

}  // namespace spigolo
