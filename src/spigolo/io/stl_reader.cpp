// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/stl_reader.cpp
#include "spigolo/io/stl_reader.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include "spigolo/core/error.h"
#include "spigolo/io/polygons.h"
#include "spigolo/io/scalar.h"
#include "spigolo/io/text.h"
#include "spigolo/io/weld.h"

namespace spigolo {
namespace {

constexpr std::size_t head_size = 84;    // 80 bytes of anything, the number of triangles
constexpr std::size_t record_size = 50;  // normal, three corners, two bytes
constexpr std::size_t normal_size = 12;

using Corners = std::array<std::uint32_t, 3>;

bool begins_with_solid(const InputBytes& input) {
  const std::string_view text = input.text().substr(0, 64);
  const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n"), text.size());
  return lower(text.substr(begin, 5)) == "solid";
}

// The size decides: a text of exactly that length for the number in it does not happen.
bool is_binary(const InputBytes& input) {
  if (input.size() < head_size) return false;
  const std::uint64_t count = load<std::uint32_t>(input.bytes.data() + 80);
  if (input.size() == head_size + count * record_size) return true;
  return !begins_with_solid(input) || input.text().substr(0, 512).find('\0') != std::string::npos;
}

void read_binary(const InputBytes& input, Welder& welder, PolygonFans& fans, ReadReport& report) {
  report.encoding = "binary_little_endian";
  const std::uint64_t count = load<std::uint32_t>(input.bytes.data() + 80);
  const std::uint64_t room = (input.size() - head_size) / record_size;
  if (count > room)
    throw InputError(input.name, "byte " + std::to_string(head_size + room * record_size),
                     "the header claims " + std::to_string(count) + " triangles, " +
                         std::to_string(room) +
                         " are there; the file is cut off or no STL, fetch it again");
  if (input.size() > head_size + count * record_size)
    report.warnings.push_back("there is more data behind the last triangle");
  report.faces = count;
  const std::byte* at = input.bytes.data() + head_size;
  for (std::uint64_t t = 0; t < count; ++t, at += record_size) {
    Corners corners{};
    for (std::size_t c = 0; c < 3; ++c) {
      Vec3 p;
      for (std::size_t axis = 0; axis < 3; ++axis)
        p[axis] = static_cast<double>(load<float>(at + normal_size + 12 * c + 4 * axis));
      corners[c] = welder.index(p);
    }
    fans.add(corners);
  }
}

// The lines of an ascii file, facet by facet.
class AsciiStl {
 public:
  AsciiStl(const InputBytes& input, Welder& welder, PolygonFans& fans, ReadReport& report)
      : lines_(input), welder_(welder), fans_(fans), report_(report) {}

  void read() {
    report_.encoding = "ascii";
    std::string_view line;
    while (lines_.next(line)) {
      const std::string keyword = lower(next_word(line));
      if (keyword == "vertex") {
        take_vertex(line);
      } else if (keyword == "endfacet") {
        if (corners_.size() < 3) lines_.fail("a facet ends before it has three vertices");
        ++report_.faces;
        fans_.add(corners_);
        corners_.clear();
      } else if (keyword == "solid" || keyword == "endsolid") {
        open_ = keyword == "solid";
      } else if (keyword != "facet" && keyword != "outer" && keyword != "endloop" &&
                 !keyword.empty()) {
        lines_.fail("'" + excerpt(keyword) + "' is no word of STL; the file is damaged");
      }
    }
    if (open_ || !corners_.empty())
      lines_.fail("'endsolid' is missing; the file is cut off, fetch it again");
  }

 private:
  void take_vertex(std::string_view rest) {
    Vec3 p;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::string_view word = next_word(rest);
      const char* at = word.data();
      if (!parse_number(at, word.data() + word.size(), p[axis]) || at != word.data() + word.size())
        lines_.fail("a vertex is 'vertex X Y Z', not '" + excerpt(word) + "'");
    }
    corners_.push_back(welder_.index(p));
  }

  LineReader lines_;
  Welder& welder_;
  PolygonFans& fans_;
  ReadReport& report_;
  std::vector<std::uint32_t> corners_;
  bool open_ = false;
};

}  // namespace

TriangleMesh read_stl(const InputBytes& input, bool with_faces, ReadReport& report) {
  report.format = "stl";
  Welder welder;
  PolygonFans fans;
  if (is_binary(input))
    read_binary(input, welder, fans, report);
  else if (begins_with_solid(input))
    AsciiStl(input, welder, fans, report).read();
  else
    throw InputError(input.name, "header", "is neither ascii nor binary STL; too short or damaged");
  TriangleMesh mesh;
  mesh.vertices.points = welder.take();
  mesh.triangles = fans.take(report);
  if (!with_faces) mesh.triangles = {};
  report.points = mesh.vertices.size();
  return mesh;
}

}  // namespace spigolo
