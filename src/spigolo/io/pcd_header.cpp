// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/pcd_header.cpp
#include "spigolo/io/pcd_header.h"

#include <optional>
#include <utility>

#include "spigolo/core/error.h"
#include "spigolo/io/names.h"
#include "spigolo/io/text.h"

namespace spigolo {
namespace {

constexpr std::uint64_t longest_padding = 65536;

using Words = std::vector<std::string_view>;

Words split(std::string_view line) {
  Words words;
  for (std::string_view w = next_word(line); !w.empty(); w = next_word(line)) words.push_back(w);
  return words;
}

// Gathers the entries; they only make sense together.
class PcdHeaderParser {
 public:
  explicit PcdHeaderParser(const InputBytes& input) : name_(input.name), text_(input.text()) {}

  PcdHeader parse() {
    while (!done_) take(next_line());
    header_.body = at_;
    header_.lines = number_;
    make_fields();
    make_points();
    return std::move(header_);
  }

 private:
  std::string_view next_line() {
    ++number_;
    const std::size_t stop = text_.find('\n', at_);
    if (stop == text_.npos) fail("the header does not end; the line 'DATA ...' is missing");
    const std::string_view line = text_.substr(at_, stop - at_);
    at_ = stop + 1;
    return line;
  }

  void take(std::string_view line) {
    if (line.substr(0, 1) == "#") return;
    Words words = split(line);
    if (words.empty()) return;
    const std::string_view key = words.front();
    words.erase(words.begin());
    if (key == "VERSION") {
      header_.version = words.empty() ? "" : excerpt(words[0]);
    } else if (key == "FIELDS" || key == "COLUMNS") {
      names_ = words;
    } else if (key == "SIZE") {
      sizes_ = words;
    } else if (key == "TYPE") {
      types_ = words;
    } else if (key == "COUNT") {
      counts_ = words;
    } else if (key == "WIDTH" || key == "HEIGHT" || key == "POINTS") {
      (key == "WIDTH" ? width_ : key == "HEIGHT" ? height_ : points_) = count(words);
    } else if (key == "DATA") {
      take_data(words);
    } else if (key != "VIEWPOINT") {
      fail("unknown keyword '" + excerpt(key) + "'; the header is damaged or it is no PCD file");
    }
  }

  void take_data(const Words& words) {
    const std::string_view kind = words.empty() ? "" : words[0];
    if (kind != "ascii" && kind != "binary" && kind != "binary_compressed")
      fail("unknown data '" + excerpt(kind) + "'; it is ascii, binary or binary_compressed");
    header_.data = kind == "ascii"    ? PcdData::ascii
                   : kind == "binary" ? PcdData::binary
                                      : PcdData::binary_compressed;
    done_ = true;
  }

  std::uint64_t count(const Words& words) const {
    std::uint64_t value = 0;
    if (words.size() != 1 || !parse_count(words[0], value)) fail("one count is expected here");
    return value;
  }

  void make_fields() {
    if (names_.empty()) fail("the line 'FIELDS ...' is missing");
    if (names_.size() > max_columns) fail("more than " + std::to_string(max_columns) + " fields");
    if (sizes_.size() != names_.size() || types_.size() != names_.size() ||
        (!counts_.empty() && counts_.size() != names_.size()))
      fail("FIELDS, SIZE, TYPE and COUNT differ in length");
    for (std::size_t f = 0; f < names_.size(); ++f) header_.fields.push_back(make_field(f));
    std::size_t columns = 0;
    for (const PcdField& field : header_.fields) columns += field.name == "_" ? 0 : field.count;
    if (columns > max_columns)
      fail("more than " + std::to_string(max_columns) + " numbers a point");
  }

  PcdField make_field(std::size_t f) const {
    std::uint64_t size = 0, n = 1;
    const bool sound = parse_count(sizes_[f], size) && types_[f].size() == 1 &&
                       (counts_.empty() || parse_count(counts_[f], n)) && n <= longest_padding;
    const char type = sound ? types_[f].front() : ' ';
    const bool integer = (type == 'I' || type == 'U') && (size == 1 || size == 2);
    const bool any = (type == 'I' || type == 'U' || type == 'F') && (size == 4 || size == 8);
    if (!integer && !any)
      fail("field '" + excerpt(names_[f]) + "' has no valid SIZE, TYPE and COUNT");
    return {std::string(names_[f]), type, static_cast<std::size_t>(size),
            static_cast<std::size_t>(n)};
  }

  void make_points() {
    if (!points_ && !width_) fail("the lines 'WIDTH ...' and 'POINTS ...' are missing");
    const std::uint64_t width = width_.value_or(0), height = height_.value_or(1);
    const bool overflows = height != 0 && width > ~std::uint64_t{0} / height;
    header_.points = points_.value_or(overflows ? ~std::uint64_t{0} : width * height);
    if (width_ && (overflows || width * height != header_.points))
      fail("WIDTH times HEIGHT is not POINTS; the header is damaged");
  }

  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError(name_, "header line " + std::to_string(number_), problem);
  }

  std::string name_;
  std::string_view text_;
  std::size_t at_ = 0, number_ = 0;
  bool done_ = false;
  Words names_, sizes_, types_, counts_;
  std::optional<std::uint64_t> width_, height_, points_;
  PcdHeader header_;
};

}  // namespace

std::size_t PcdHeader::row_size() const {
  std::size_t size = 0;
  for (const PcdField& f : fields) size += f.size * f.count;
  return size;
}

std::size_t PcdHeader::row_numbers() const {
  std::size_t numbers = 0;
  for (const PcdField& f : fields) numbers += f.count;
  return numbers;
}

PcdHeader parse_pcd_header(const InputBytes& input) { return PcdHeaderParser(input).parse(); }

}  // namespace spigolo
