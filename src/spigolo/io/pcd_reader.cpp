// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/pcd_reader.cpp
#include "spigolo/io/pcd_reader.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "spigolo/core/error.h"
#include "spigolo/io/lzf.h"
#include "spigolo/io/names.h"
#include "spigolo/io/pcd_header.h"
#include "spigolo/io/scalar.h"
#include "spigolo/io/text.h"

namespace spigolo {
namespace {

constexpr std::array<const char*, 3> data_names = {"ascii", "binary_little_endian",
                                                   "binary_compressed"};

bool is_packed_colour(const PcdField& f) {
  return (f.name == "rgb" || f.name == "rgba") && f.size == 4 && f.count == 1;
}

ScalarType type_of(const PcdField& f) {
  if (f.type == 'F') return f.size == 4 ? ScalarType::float32 : ScalarType::float64;
  const bool has_sign = f.type == 'I';
  if (f.size == 1) return has_sign ? ScalarType::int8 : ScalarType::uint8;
  if (f.size == 2) return has_sign ? ScalarType::int16 : ScalarType::uint16;
  if (f.size == 4) return has_sign ? ScalarType::int32 : ScalarType::uint32;
  return ScalarType::float64;
}

// A packed colour comes as the number of its bits, which as a float may be NaN.
double load_number(const std::byte* at, const PcdField& f) {
  if (is_packed_colour(f)) return load<std::uint32_t>(at);
  if (f.size == 8 && f.type == 'I') return static_cast<double>(load<std::int64_t>(at));
  if (f.size == 8 && f.type == 'U') return static_cast<double>(load<std::uint64_t>(at));
  return load_scalar(at, type_of(f), ByteOrder::little);
}

double read_number(WordReader& words, const PcdField& f) {
  const double value = words.number(type_of(f));
  if (is_packed_colour(f) && f.type == 'F')
    return std::bit_cast<std::uint32_t>(narrow<float>(value));
  return value;
}

class PcdReader {
 public:
  PcdReader(const InputBytes& input, ReadReport& report)
      : input_(input), header_(parse_pcd_header(input)), report_(report) {}

  PointCloud read() {
    report_.format = "pcd";
    report_.version = header_.version;
    report_.encoding = data_names[static_cast<std::size_t>(header_.data)];
    report_.points = header_.points;
    find_axes();
    if (header_.data == PcdData::ascii)
      read_ascii();
    else if (header_.data == PcdData::binary)
      read_binary();
    else
      read_compressed();
    return std::move(cloud_);
  }

 private:
  void find_axes() {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto it = std::find_if(header_.fields.begin(), header_.fields.end(), [&](auto& f) {
        return f.name == std::array{"x", "y", "z"}[axis] && f.count == 1;
      });
      if (it == header_.fields.end())
        throw InputError(input_.name, "header", "there are no fields x, y, z; it holds no points");
      axes_[axis] = static_cast<std::size_t>(it - header_.fields.begin());
    }
  }

  [[noreturn]] void fail_short(std::uint64_t room) const {
    throw InputError(input_.name, "byte " + std::to_string(input_.size()),
                     "the header claims " + std::to_string(header_.points) +
                         " points, the file has room for at most " + std::to_string(room) +
                         "; it is cut off or damaged, fetch it again");
  }

  // Takes the numbers of one column: element e of field f.
  void add_column(std::size_t f, std::size_t e, std::vector<double> values) {
    const PcdField& field = header_.fields[f];
    const auto axis = std::find(axes_.begin(), axes_.end(), f);
    if (axis != axes_.end()) {
      cloud_.points.resize(values.size());
      for (std::size_t i = 0; i < values.size(); ++i)
        cloud_.points[i][static_cast<std::size_t>(axis - axes_.begin())] = values[i];
    } else if (is_packed_colour(field)) {
      add_packed_colour(values, field.name == "rgba");
    } else {
      const std::string name = field.count == 1 ? field.name : field.name + "_" + std::to_string(e);
      cloud_.attributes.push_back({unique_(name), type_of(field), std::move(values)});
    }
  }

  void add_packed_colour(const std::vector<double>& values, bool has_alpha) {
    constexpr std::array<std::pair<const char*, unsigned>, 4> channels = {
        {{"red", 16}, {"green", 8}, {"blue", 0}, {"alpha", 24}}};
    for (std::size_t c = 0; c < (has_alpha ? 4u : 3u); ++c) {
      std::vector<double> channel(values.size());
      for (std::size_t i = 0; i < values.size(); ++i)
        channel[i] = narrow<std::uint32_t>(values[i]) >> channels[c].second & 0xff;
      cloud_.attributes.push_back(
          {unique_(channels[c].first), ScalarType::uint8, std::move(channel)});
    }
  }

  void read_ascii() {
    WordReader words(input_.name, input_.text().substr(header_.body), header_.lines + 1);
    const std::uint64_t room = (words.rest() + 1) / (2 * header_.row_numbers());
    if (header_.points > room) fail_short(room);
    std::vector<std::vector<double>> columns;
    for (const PcdField& f : header_.fields)
      for (std::size_t e = 0; e < (f.name == "_" ? 0 : f.count); ++e)
        columns.emplace_back().reserve(header_.points);
    for (std::uint64_t row = 0; row < header_.points; ++row) {
      std::size_t c = 0;
      for (const PcdField& f : header_.fields)
        for (std::size_t e = 0; e < f.count; ++e) {
          const double value = read_number(words, f);
          if (f.name != "_") columns[c++].push_back(value);
        }
    }
    if (!words.at_end()) report_.warnings.push_back("there is more data behind the last point");
    std::size_t c = 0;
    for (std::size_t f = 0; f < header_.fields.size(); ++f)
      for (std::size_t e = 0; e < (is_padding(f) ? 0 : header_.fields[f].count); ++e)
        add_column(f, e, std::move(columns[c++]));
  }

  bool is_padding(std::size_t f) const { return header_.fields[f].name == "_"; }

  // body: either point by point, or field by field.
  void read_columns(std::span<const std::byte> body, bool by_field) {
    std::size_t offset = 0;  // of the field in a row
    for (std::size_t f = 0; f < header_.fields.size(); ++f) {
      const PcdField& field = header_.fields[f];
      const std::size_t stride = by_field ? field.size * field.count : header_.row_size();
      const std::byte* first = body.data() + (by_field ? offset * header_.points : offset);
      for (std::size_t e = 0; e < (is_padding(f) ? 0 : field.count); ++e) {
        std::vector<double> values(header_.points);
        for (std::size_t i = 0; i < values.size(); ++i)
          values[i] = load_number(first + i * stride + e * field.size, field);
        add_column(f, e, std::move(values));
      }
      offset += field.size * field.count;
    }
  }

  void read_binary() {
    const std::span<const std::byte> body = input_.bytes.subspan(header_.body);
    const std::uint64_t room = body.size() / header_.row_size();
    if (header_.points > room) fail_short(room);
    read_columns(body, false);
    if (body.size() > header_.points * header_.row_size())
      report_.warnings.push_back("there is more data behind the last point");
  }

  void read_compressed() {
    std::span<const std::byte> body = input_.bytes.subspan(header_.body);
    if (body.size() < 8) fail_short(0);
    const std::size_t packed = load<std::uint32_t>(body.data());
    const std::size_t plain = load<std::uint32_t>(body.data() + 4);
    body = body.subspan(8);
    if (packed > body.size()) fail_short(0);
    if (plain % header_.row_size() != 0 || plain / header_.row_size() != header_.points)
      throw InputError(input_.name, "byte " + std::to_string(header_.body + 4),
                       "the compressed data is not of " + std::to_string(header_.points) +
                           " points; the file is damaged");
    if (plain / lzf_largest_growth > packed) fail_short(0);
    std::vector<std::byte> columns(plain);
    if (!lzf_decompress(body.first(packed), columns))
      throw InputError(input_.name, "byte " + std::to_string(header_.body + 8),
                       "the compressed data is damaged; fetch the file again");
    read_columns(columns, true);
  }

  const InputBytes& input_;
  PcdHeader header_;
  ReadReport& report_;
  std::array<std::size_t, 3> axes_{};
  PointCloud cloud_;
  UniqueNames unique_{"x", "y", "z"};
};

}  // namespace

PointCloud read_pcd(const InputBytes& input, ReadReport& report) {
  return PcdReader(input, report).read();
}

}  // namespace spigolo
