// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/text_row.h - one line of a table of numbers
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace spigolo {

struct RowResult {
  bool empty = false;           // blank or a comment
  bool open_end = false;        // ends with a separator
  const char* stuck = nullptr;  // where something stands that is not a number
};

/// The numbers of a line, into row. An empty field between separators is NaN.
RowResult parse_row(std::string_view line, std::vector<double>& row);

/// True for a line such as "1,5 2,5 3,5" or "1,5;2,5;3,5": commas between digits, another separator
/// between digits as well, and no point.
bool has_decimal_comma(std::string_view line);

/// True if the line begins with what cannot be meant as a number.
bool starts_with_name(std::string_view line);

/// The names of a header line, without quotes; split at commas or semicolons if there are any, else
/// at blanks.
std::vector<std::string> split_names(std::string_view line);

/// Renames r, g, b and any spelling of red, green, blue to the latter, if all three are there.
void name_colours(std::vector<std::string>& names);
bool is_colour_name(std::string_view name);
/// All values whole numbers in 0..255.
bool is_colour_column(const std::vector<double>& values);

}  // namespace spigolo
