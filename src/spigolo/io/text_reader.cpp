// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/text_reader.cpp
#include "spigolo/io/text_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "spigolo/core/error.h"
#include "spigolo/io/names.h"
#include "spigolo/io/text.h"
#include "spigolo/io/text_row.h"

namespace spigolo {
namespace {

constexpr std::size_t none = ~std::size_t{0};

// Collects the rows of one file.
class TextTable {
 public:
  TextTable(const InputBytes& input, bool is_pts, ReadReport& report)
      : lines_(input), input_(input), is_pts_(is_pts), report_(report) {}

  PointCloud read() {
    report_.format = "text";
    report_.encoding = "ascii";
    std::string_view line;
    while (lines_.next(line)) take(line);
    if (columns_ == 0)
      throw InputError(input_.name, "line " + std::to_string(lines_.number()),
                       "no point in the file; a line needs at least three numbers");
    check_count();
    report_.points = cloud_.size();
    name_columns();
    return std::move(cloud_);
  }

 private:
  void take(std::string_view line) {
    const RowResult result = parse_row(line, row_);
    if (result.empty) {
      if (columns_ == 0) comment_ = line;
    } else if (result.stuck != nullptr) {
      take_words(line, result.stuck);
    } else if (row_.size() == 1 && takes_count()) {
      declared_ = declared_.value_or(0) + row_[0];
    } else {
      if (columns_ == 0) start(line);
      take_row(line, result.open_end);
    }
  }

  // A whole number alone on its line: before the first point, or before the next scan of a .pts.
  bool takes_count() const {
    const double n = row_[0];
    return (columns_ == 0 || is_pts_) && n >= 0 && n < 0x1p53 && n == std::floor(n);
  }

  // A line that is not all numbers: names if it is the first, else damage.
  void take_words(std::string_view line, const char* stuck) {
    std::string_view rest = line;
    if (columns_ == 0 && names_.empty() && row_.empty() && starts_with_name(line)) {
      names_ = split_names(line);
      return;
    }
    rest.remove_prefix(static_cast<std::size_t>(stuck - line.data()));
    if (has_decimal_comma(line)) fail_comma();
    lines_.fail("'" + excerpt(rest) + "' is not a number");
  }

  [[noreturn]] void fail_comma() {
    lines_.fail("this looks like decimal commas, which are not supported; write 1.5 for 1,5");
  }

  // The first row decides how many columns there are and which are the position.
  void start(std::string_view line) {
    if (has_decimal_comma(line)) fail_comma();
    if (row_.size() < 3)
      lines_.fail("only " + std::to_string(row_.size()) + " numbers; a point needs at least three");
    if (row_.size() > max_columns)
      lines_.fail("more than " + std::to_string(max_columns) + " numbers on one line");
    columns_ = row_.size();
    use_comment_as_names();
    find_axes();
    extra_.resize(columns_ - 3);
    // A row is never shorter than its numbers and the separators between them.
    const std::size_t rows = lines_.rest() / std::max(line.size(), 2 * columns_ - 1) + 1;
    cloud_.points.reserve(rows);
    for (std::vector<double>& column : extra_) column.reserve(rows);
  }

  void use_comment_as_names() {
    if (!names_.empty()) return;
    const std::size_t begin = comment_.find_first_not_of("#/; \t");
    if (begin == comment_.npos) return;
    std::vector<std::string> names = split_names(comment_.substr(begin));
    if (names.size() == columns_ && lower(names[0]) == "x" && lower(names[1]) == "y" &&
        lower(names[2]) == "z")
      names_ = std::move(names);
  }

  void find_axes() {
    std::array<std::size_t, 3> found{none, none, none};
    for (std::size_t c = 0; c < names_.size() && c < columns_; ++c)
      for (std::size_t axis = 0; axis < 3; ++axis)
        if (found[axis] == none && lower(names_[c]) == std::array{"x", "y", "z"}[axis])
          found[axis] = c;
    if (std::find(found.begin(), found.end(), none) == found.end()) axes_ = found;
    for (std::size_t c = 0; c < columns_; ++c)
      if (std::find(axes_.begin(), axes_.end(), c) == axes_.end()) extra_columns_.push_back(c);
  }

  void take_row(std::string_view line, bool open_end) {
    if (row_.size() + 1 == columns_ && open_end) row_.push_back(not_a_number);
    if (row_.size() != columns_) {
      if (has_decimal_comma(line)) fail_comma();
      lines_.fail(std::to_string(row_.size()) + " numbers where the lines before have " +
                  std::to_string(columns_) + "; the line is cut off or damaged");
    }
    cloud_.points.push_back({row_[axes_[0]], row_[axes_[1]], row_[axes_[2]]});
    for (std::size_t e = 0; e < extra_.size(); ++e) extra_[e].push_back(row_[extra_columns_[e]]);
  }

  void check_count() {
    if (!declared_) return;
    const auto found = static_cast<double>(cloud_.size());
    const std::string counts = std::to_string(static_cast<std::uint64_t>(*declared_)) +
                               " points are declared, " + std::to_string(cloud_.size()) +
                               " are there";
    if (*declared_ > found) lines_.fail(counts + "; the file is cut off, fetch it again");
    if (*declared_ < found) report_.warnings.push_back(counts);
  }

  void name_columns() {
    UniqueNames unique{"x", "y", "z"};
    std::vector<std::string> names;
    for (const std::size_t c : extra_columns_) names.push_back(given_name(c));
    name_colours(names);
    const bool guess = names_.empty() && (columns_ == 6 || columns_ == 7);
    if (guess && std::all_of(extra_.end() - 3, extra_.end(), is_colour_column))
      for (std::size_t i = 0; i < 3; ++i)
        names[names.size() - 3 + i] = std::array{"red", "green", "blue"}[i];
    for (std::size_t e = 0; e < extra_.size(); ++e) {
      const bool colour = is_colour_name(names[e]) && is_colour_column(extra_[e]);
      cloud_.attributes.push_back({unique(names[e]),
                                   colour ? ScalarType::uint8 : ScalarType::float64,
                                   std::move(extra_[e])});
    }
  }

  std::string given_name(std::size_t column) const {
    if (column < names_.size() && !names_[column].empty()) return names_[column];
    if (names_.empty() && is_pts_ && column == 3) return "intensity";
    return "scalar_" + std::to_string(column);
  }

  LineReader lines_;
  const InputBytes& input_;
  bool is_pts_;
  ReadReport& report_;
  PointCloud cloud_;
  std::vector<double> row_;
  std::vector<std::string> names_;
  std::string_view comment_;  // the last comment before the first point
  std::size_t columns_ = 0;   // 0: no point yet
  std::array<std::size_t, 3> axes_{0, 1, 2};
  std::vector<std::size_t> extra_columns_;
  std::vector<std::vector<double>> extra_;
  std::optional<double> declared_;
};

}  // namespace

PointCloud read_text(const InputBytes& input, bool is_pts, ReadReport& report) {
  return TextTable(input, is_pts, report).read();
}

}  // namespace spigolo
