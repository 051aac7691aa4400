// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/ply_header.cpp
#include "spigolo/io/ply_header.h"

#include <algorithm>
#include <array>
#include <utility>

#include "spigolo/core/error.h"
#include "spigolo/io/names.h"
#include "spigolo/io/text.h"

namespace spigolo {
namespace {

constexpr std::array<std::pair<const char*, const char*>, 8> type_names = {{{"char", "int8"},
                                                                            {"uchar", "uint8"},
                                                                            {"short", "int16"},
                                                                            {"ushort", "uint16"},
                                                                            {"int", "int32"},
                                                                            {"uint", "uint32"},
                                                                            {"float", "float32"},
                                                                            {"double", "float64"}}};

// The lines of a header; all end as the first one does, so that a binary body that begins with a
// line feed keeps it.
class HeaderLines {
 public:
  explicit HeaderLines(const InputBytes& input) : name_(input.name), text_(input.text()) {
    if (text_.substr(0, 3) != "ply" || text_.size() < 4 || (text_[3] != '\n' && text_[3] != '\r'))
      throw InputError(name_, "header", "does not begin with the line 'ply'; it is no PLY file");
    line_end_ = text_[3] == '\n' ? "\n" : text_.substr(3, 2) == "\r\n" ? "\r\n" : "\r";
  }

  std::string_view next() {
    ++number_;
    const std::size_t stop = text_.find(line_end_, at_);
    if (stop == text_.npos) fail("the header does not end; 'end_header' is missing");
    const std::string_view line = text_.substr(at_, stop - at_);
    at_ = stop + line_end_.size();
    return line;
  }
  std::size_t offset() const { return at_; }
  std::size_t number() const { return number_; }
  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError(name_, "header line " + std::to_string(number_), problem);
  }

 private:
  std::string name_;
  std::string_view text_;
  std::string_view line_end_;
  std::size_t at_ = 0;
  std::size_t number_ = 0;
};

ScalarType parse_type(const HeaderLines& lines, std::string_view word) {
  for (std::size_t i = 0; i < type_names.size(); ++i)
    if (word == type_names[i].first || word == type_names[i].second)
      return static_cast<ScalarType>(i);
  lines.fail("unknown type '" + excerpt(word) + "'; PLY has char to double and int8 to float64");
}

void parse_format(const HeaderLines& lines, std::string_view rest, PlyHeader& header) {
  const std::string_view encoding = next_word(rest);
  header.ascii = encoding == "ascii";
  header.order = encoding == "binary_big_endian" ? ByteOrder::big : ByteOrder::little;
  if (!header.ascii && encoding != "binary_big_endian" && encoding != "binary_little_endian")
    lines.fail("unknown format '" + excerpt(encoding) +
               "'; it is ascii, binary_little_endian or binary_big_endian");
}

void parse_element(const HeaderLines& lines, std::string_view rest, PlyHeader& header) {
  PlyElementHeader element;
  element.name = next_word(rest);
  const std::string_view count = next_word(rest);
  if (element.name.empty() || !parse_count(count, element.count))
    lines.fail("an element line is 'element NAME COUNT', not '" + excerpt(count) + "'");
  if (header.elements.size() == max_columns) lines.fail("too many elements");
  header.elements.push_back(std::move(element));
}

void parse_property(const HeaderLines& lines, std::string_view rest, PlyHeader& header) {
  if (header.elements.empty()) lines.fail("a property stands before the first element");
  PlyProperty property;
  std::string_view word = next_word(rest);
  if (word == "list") {
    property.count_type = parse_type(lines, next_word(rest));
    if (!is_integer(*property.count_type)) lines.fail("a list length cannot be a float");
    word = next_word(rest);
  }
  property.type = parse_type(lines, word);
  property.name = next_word(rest);
  if (property.name.empty()) lines.fail("a property has no name");
  if (header.elements.back().properties.size() == max_columns)
    lines.fail("more than " + std::to_string(max_columns) + " properties");
  header.elements.back().properties.push_back(std::move(property));
}

}  // namespace

bool PlyElementHeader::has_list() const {
  return std::any_of(properties.begin(), properties.end(),
                     [](const PlyProperty& p) { return p.is_list(); });
}

std::size_t PlyElementHeader::least_row_size() const {
  std::size_t size = 0;
  for (const PlyProperty& p : properties) size += size_of(p.count_type.value_or(p.type));
  return size;
}

PlyHeader parse_ply_header(const InputBytes& input) {
  HeaderLines lines(input);
  PlyHeader header;
  bool has_format = false;
  lines.next();
  while (true) {
    std::string_view rest = lines.next();
    const std::string_view keyword = next_word(rest);
    if (keyword == "end_header") break;
    if (keyword == "format") {
      parse_format(lines, rest, header);
      has_format = true;
    } else if (keyword == "element") {
      parse_element(lines, rest, header);
    } else if (keyword == "property") {
      parse_property(lines, rest, header);
    } else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info") {
      lines.fail("unknown keyword '" + excerpt(keyword) + "'; the header is damaged");
    }
  }
  if (!has_format) lines.fail("the line 'format ...' is missing");
  header.body = lines.offset();
  header.lines = lines.number();
  return header;
}

const char* ply_type_name(ScalarType type) {
  return type_names[static_cast<std::size_t>(type)].first;
}

}  // namespace spigolo
