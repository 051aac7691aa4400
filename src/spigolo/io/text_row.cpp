// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/text_row.cpp
#include "spigolo/io/text_row.h"

#include <algorithm>
#include <cmath>

#include "spigolo/core/geometry.h"
#include "spigolo/io/text.h"

namespace spigolo {
namespace {

bool is_separator(char c) { return c == ',' || c == ';'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool starts_comment(const char* p, const char* end) {
  return *p == '#' || (*p == '/' && p + 1 != end && p[1] == '/');
}

const char* skip_blanks(const char* p, const char* end) {
  while (p != end && is_blank(*p)) ++p;
  return p;
}

}  // namespace

RowResult parse_row(std::string_view line, std::vector<double>& row) {
  row.clear();
  const char* end = line.data() + line.size();
  const char* p = skip_blanks(line.data(), end);
  RowResult result;
  result.empty = p == end || starts_comment(p, end) || *p == ';';
  if (result.empty) return result;
  while (p != end && !starts_comment(p, end)) {
    double value = not_a_number;
    const bool sound = is_separator(*p) || parse_number(p, end, value);
    if (!sound || (p != end && !is_separator(*p) && !is_blank(*p) && !starts_comment(p, end))) {
      result.stuck = p;
      return result;
    }
    row.push_back(value);
    p = skip_blanks(p, end);
    result.open_end = p != end && is_separator(*p);
    if (result.open_end) p = skip_blanks(p + 1, end);
  }
  return result;
}

bool has_decimal_comma(std::string_view line) {
  bool comma = false, other = false;
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    if (line[i] == '.') return false;
    if (!is_digit(line[i - 1])) continue;
    comma = comma || (line[i] == ',' && is_digit(line[i + 1]));
    if (line[i] == ';' || is_blank(line[i])) {
      const std::size_t next = line.find_first_not_of(" \t;", i);
      other = other || (next != line.npos && (is_digit(line[next]) || line[next] == '-'));
    }
  }
  return comma && other;
}

bool starts_with_name(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t");
  return first != line.npos && !is_digit(line[first]) && line[first] != '.' && line[first] != '-' &&
         line[first] != '+';
}

std::vector<std::string> split_names(std::string_view line) {
  const bool separated = std::any_of(line.begin(), line.end(), is_separator);
  std::vector<std::string> names;
  std::string name;
  const auto finish = [&] {
    const std::size_t begin = name.find_first_not_of(" \t\""),
                      last = name.find_last_not_of(" \t\"");
    names.push_back(begin == name.npos ? "" : name.substr(begin, last - begin + 1));
    name.clear();
  };
  for (const char c : line) {
    const bool ends = separated ? is_separator(c) : is_blank(c);
    if (!ends)
      name += c;
    else if (separated || !name.empty())
      finish();
  }
  if (!name.empty()) finish();
  return names;
}

void name_colours(std::vector<std::string>& names) {
  std::vector<std::string*> found;
  for (const char* colour : {"red", "green", "blue"})
    for (std::string& name : names) {
      const std::string small = lower(name);
      if (small != colour && small != std::string(1, *colour)) continue;
      found.push_back(&name);
      break;
    }
  if (found.size() < 3) return;
  *found[0] = "red", *found[1] = "green", *found[2] = "blue";
}

bool is_colour_name(std::string_view name) {
  return name == "red" || name == "green" || name == "blue";
}

bool is_colour_column(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(),
                     [](double v) { return v >= 0 && v <= 255 && v == std::floor(v); });
}

}  // namespace spigolo
