// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/off_reader.cpp
#include "spigolo/io/off_reader.h"

#include <algorithm>
#include <array>
#include <utility>

#include "spigolo/core/error.h"
#include "spigolo/io/colours.h"
#include "spigolo/io/polygons.h"
#include "spigolo/io/text.h"

namespace spigolo {
namespace {

constexpr std::size_t least_vertex = 6;  // bytes of the line "0 0 0"
constexpr std::size_t least_face = 2;    // bytes of the line "0"

class OffReader {
 public:
  OffReader(const InputBytes& input, bool with_faces, ReadReport& report)
      : lines_(input), with_faces_(with_faces), report_(report) {}

  TriangleMesh read() {
    report_.format = "off";
    report_.encoding = "ascii";
    read_header();
    for (std::uint64_t i = 0; i < report_.points; ++i) read_vertex();
    for (std::uint64_t i = 0; i < report_.faces; ++i) read_face();
    finish();
    return std::move(mesh_);
  }

 private:
  std::string_view content() {
    std::string_view line;
    if (!lines_.next_content(line)) lines_.fail("the file is cut off here; fetch it again");
    return line;
  }

  void read_keyword(std::string_view& line) {
    std::string_view rest = line;
    const std::string_view word = next_word(rest);
    std::uint64_t count = 0;
    if (parse_count(word, count)) return;  // the keyword may be missing
    if (word != "OFF" && word != "COFF" && word != "NOFF" && word != "CNOFF")
      lines_.fail("'" + excerpt(word) + "' is not OFF, COFF, NOFF or CNOFF");
    colours_ = word.front() == 'C';
    normals_ = word == "NOFF" || word == "CNOFF";
    std::string_view ahead = rest;
    if (next_word(ahead) == "BINARY")
      lines_.fail("binary OFF is not supported; save it as text or as PLY");
    line = rest;
  }

  void read_header() {
    std::string_view line = content();
    read_keyword(line);
    std::string_view word = next_word(line);
    if (word.empty()) {
      line = content();
      word = next_word(line);
    }
    const std::string_view faces = next_word(line);
    if (!parse_count(word, report_.points) || !parse_count(faces, report_.faces))
      lines_.fail("the numbers of vertices and faces are expected here");
    // The last line may lack its end.
    if (report_.points > (lines_.rest() + 1) / least_vertex ||
        report_.faces > (lines_.rest() + 1) / least_face)
      lines_.fail("the header claims " + std::to_string(report_.points) + " vertices and " +
                  std::to_string(report_.faces) +
                  " faces, the file is too short for them; it is cut off or damaged");
    mesh_.vertices.points.reserve(report_.points);
  }

  double number(std::string_view word) {
    const char* p = word.data();
    const char* const end = p + word.size();
    double value = 0;
    if (word.empty()) lines_.fail("the line has too few numbers; it is cut off or damaged");
    if (!parse_number(p, end, value) || p != end)
      lines_.fail("'" + excerpt(word) + "' is not a number");
    return value;
  }

  void read_vertex() {
    std::string_view line = content();
    const double x = number(next_word(line)), y = number(next_word(line)),
                 z = number(next_word(line));
    mesh_.vertices.points.push_back({x, y, z});
    for (std::size_t c = 0; normals_ && c < 3; ++c) normal_[c].push_back(number(next_word(line)));
    if (!colours_) return;
    for (std::size_t c = 0; c < 4; ++c) {
      const std::string_view word = next_word(line);
      if (word.empty() && c == 3) break;  // alpha may be missing
      whole_ = whole_ && word.find('.') == word.npos;
      channels_[c].push_back(number(word));
    }
  }

  void read_face() {
    std::string_view line = content();
    if (!with_faces_) return;
    std::uint64_t corners = 0, index = 0;
    if (!parse_count(next_word(line), corners)) lines_.fail("a face begins with its corner count");
    corners_.clear();
    for (std::uint64_t c = 0; c < corners; ++c) {
      const std::string_view word = next_word(line);
      if (!parse_count(word, index) || index >= mesh_.vertices.size())
        lines_.fail("'" + excerpt(word) + "' names no vertex; there are " +
                    std::to_string(mesh_.vertices.size()) + ", counted from 0");
      corners_.push_back(static_cast<std::uint32_t>(index));
    }
    fans_.add(corners_);
  }

  void finish() {
    for (std::size_t c = 0; normals_ && c < 3; ++c)
      mesh_.vertices.set(std::array{"nx", "ny", "nz"}[c], ScalarType::float64,
                         std::move(normal_[c]));
    if (channels_[3].size() != mesh_.vertices.size() || channels_[3].empty()) channels_.pop_back();
    if (colours_) add_colours(mesh_.vertices, std::move(channels_), whole_);
    std::string_view line;
    if (lines_.next_content(line))
      report_.warnings.push_back("there is more data behind the last face");
    mesh_.triangles = fans_.take(report_);
  }

  LineReader lines_;
  bool with_faces_;
  ReadReport& report_;
  TriangleMesh mesh_;
  PolygonFans fans_;
  bool colours_ = false, normals_ = false;
  bool whole_ = true;  // colours are 0..255, not 0..1
  std::vector<std::vector<double>> channels_{4};
  std::array<std::vector<double>, 3> normal_;
  std::vector<std::uint32_t> corners_;
};

}  // namespace

TriangleMesh read_off(const InputBytes& input, bool with_faces, ReadReport& report) {
  return OffReader(input, with_faces, report).read();
}

}  // namespace spigolo
