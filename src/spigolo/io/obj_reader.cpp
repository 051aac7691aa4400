// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/obj_reader.cpp
#include "spigolo/io/obj_reader.h"

#include <array>
#include <charconv>
#include <utility>

#include "spigolo/core/error.h"
#include "spigolo/io/colours.h"
#include "spigolo/io/polygons.h"
#include "spigolo/io/text.h"

namespace spigolo {
namespace {

constexpr std::size_t most_numbers = 7;  // x y z w r g b

class ObjReader {
 public:
  ObjReader(const InputBytes& input, bool with_faces, ReadReport& report, FileLines* file_lines)
      : lines_(input),
        input_(input),
        with_faces_(with_faces),
        report_(report),
        file_lines_(file_lines) {}

  TriangleMesh read() {
    report_.format = "obj";
    report_.encoding = "ascii";
    std::string_view line;
    while (lines_.next(line)) {
      if (line.empty() || line.back() != '\\')
        take(line);
      else
        take(joined(line));
    }
    finish();
    return std::move(mesh_);
  }

 private:
  PointCloud& cloud() { return mesh_.vertices; }

  // A backslash at the end of a line goes on in the next one.
  std::string joined(std::string_view line) {
    std::string whole;
    do {
      whole.append(line.substr(0, line.find_last_not_of('\\') + 1)) += ' ';
    } while (!line.empty() && line.back() == '\\' && lines_.next(line));
    return whole;
  }

  void take(std::string_view line) {
    line = line.substr(0, line.find('#'));
    const std::string_view keyword = next_word(line);
    if (keyword == "v") {
      take_vertex(line);
    } else if (keyword == "f") {
      ++report_.faces;
      if (with_faces_) take_face(line);
    } else if (keyword == "l") {
      ++report_.lines;
      if (file_lines_ != nullptr) take_line(line);
    }
  }

  void take_vertex(std::string_view rest) {
    std::array<double, most_numbers> numbers{};
    std::size_t n = 0;
    for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest)) {
      const char* p = word.data();
      const char* const end = p + word.size();
      if (n == most_numbers) lines_.fail("a vertex has more than 7 numbers");
      if (!parse_number(p, end, numbers[n++]) || p != end)
        lines_.fail("'" + excerpt(word) + "' is not a number");
    }
    if (n < 3) lines_.fail("a vertex has " + std::to_string(n) + " numbers; it needs three");
    cloud().points.push_back({numbers[0], numbers[1], numbers[2]});
    if (n < 6 || channels_[0].size() + 1 != cloud().size()) return;
    for (std::size_t c = 0; c < 3; ++c) {
      const double value = numbers[n - 3 + c];
      channels_[c].push_back(value);
    }
  }

  std::uint32_t corner(std::string_view word) {
    const std::string_view index = word.substr(0, word.find('/'));
    std::int64_t number = 0;
    const auto [stop, error] = std::from_chars(index.data(), index.data() + index.size(), number);
    if (error != std::errc{} || stop != index.data() + index.size() || number == 0)
      lines_.fail("'" + excerpt(word) + "' names no vertex; faces and lines count them from 1");
    const auto known = static_cast<std::int64_t>(cloud().size());
    if (number < -known) lines_.fail("'" + excerpt(word) + "' counts back behind the first vertex");
    const std::int64_t at = number > 0 ? number - 1 : known + number;
    if (at >= static_cast<std::int64_t>(max_mesh_vertices))
      lines_.fail("'" + excerpt(word) + "' is too large for a vertex");
    if (at > largest_) {
      largest_ = at;
      largest_line_ = lines_.number();
    }
    return static_cast<std::uint32_t>(at);
  }

  void take_line(std::string_view rest) {
    corners_.clear();
    for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest))
      corners_.push_back(corner(word));
    if (corners_.size() > 1) file_lines_->push_back(corners_);
  }

  void take_face(std::string_view rest) {
    corners_.clear();
    for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest))
      corners_.push_back(corner(word));
    fans_.add(corners_);
  }

  void finish() {
    if (cloud().size() == 0)
      throw InputError(input_.name, "line " + std::to_string(lines_.number()),
                       "there is no vertex ('v x y z') in the file");
    if (largest_ >= static_cast<std::int64_t>(cloud().size()))
      throw InputError(input_.name, "line " + std::to_string(largest_line_),
                       "a face or line names vertex " + std::to_string(largest_ + 1) + " of " +
                           std::to_string(cloud().size()) + "; the file is cut off or damaged");
    report_.points = cloud().size();
    if (channels_[0].size() == cloud().size())
      add_colours(cloud(), std::move(channels_), false);
    else if (!channels_[0].empty())
      report_.warnings.push_back("only some vertices have colours; they were left out");
    mesh_.triangles = fans_.take(report_);
  }

  LineReader lines_;
  const InputBytes& input_;
  bool with_faces_;
  ReadReport& report_;
  FileLines* file_lines_;
  TriangleMesh mesh_;
  PolygonFans fans_;
  std::vector<std::vector<double>> channels_{3};  // colours, as long as every vertex had one
  std::vector<std::uint32_t> corners_;
  std::int64_t largest_ = -1;  // index a face or line names
  std::size_t largest_line_ = 0;
};

}  // namespace

TriangleMesh read_obj(const InputBytes& input, bool with_faces, ReadReport& report,
                      FileLines* lines) {
  return ObjReader(input, with_faces, report, lines).read();
}

}  // namespace spigolo
