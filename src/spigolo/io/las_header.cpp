// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/las_header.cpp
#include "spigolo/io/las_header.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "spigolo/core/error.h"
#include "spigolo/io/las_layout.h"
#include "spigolo/io/names.h"
#include "spigolo/io/scalar.h"

namespace spigolo {
namespace {

constexpr std::size_t type_count = 10;  // extra byte types of one number
constexpr std::array<std::size_t, type_count + 1> type_sizes = {0, 1, 1, 2, 2, 4, 4, 8, 8, 4, 8};
constexpr std::array<ScalarType, type_count + 1> scalar_types = {
    ScalarType::uint8,   ScalarType::uint8,   ScalarType::int8,   ScalarType::uint16,
    ScalarType::int16,   ScalarType::uint32,  ScalarType::int32,  ScalarType::float64,
    ScalarType::float64, ScalarType::float32, ScalarType::float64};
constexpr std::uint8_t uint64_type = 7, int64_type = 8, last_array_type = 30;
constexpr unsigned scale_flag = 8, shift_flag = 16;
constexpr std::uint16_t extra_record_id = 4;

class LasHeaderParser {
 public:
  LasHeaderParser(const InputBytes& input, ReadReport& report) : input_(input), report_(report) {}

  LasHeader parse() {
    check_start();
    parse_format();
    parse_grid();
    parse_points();
    parse_records();
    return header_;
  }

 private:
  template <class T>
  T at(std::size_t offset) const {
    return load<T>(input_.bytes.data() + offset);
  }
  [[noreturn]] void fail(std::uint64_t byte, const std::string& problem) const {
    throw InputError(input_.name, "byte " + std::to_string(byte), problem);
  }

  void check_start() {
    if (input_.text().substr(0, 4) != "LASF")
      fail(0, "does not begin with 'LASF'; it is no LAS file");
    if (input_.size() < las_header_sizes[0])
      fail(input_.size(), "the header is cut off; fetch the file again");
    const int major = at<std::uint8_t>(24);
    header_.minor = at<std::uint8_t>(25);
    if (major != 1 || header_.minor > 4)
      fail(24, "LAS version " + std::to_string(major) + "." + std::to_string(header_.minor) +
                   " is not known; 1.0 to 1.4 are");
    header_size_ = at<std::uint16_t>(94);
    const std::size_t least = las_header_sizes[static_cast<std::size_t>(header_.minor)];
    if (header_size_ < least || header_size_ > input_.size())
      fail(94,
           "the header size " + std::to_string(header_size_) + " cannot be; the file is damaged");
  }

  void parse_format() {
    const auto format = at<std::uint8_t>(104);
    // LASzip marks compressed points in the two upper bits.
    if ((format & 0xc0) != 0)
      fail(104,
           "the points are compressed (LAZ), which is not supported; decompress them first: "
           "laszip -i in.laz -o out.las");
    if (format >= las_formats)
      fail(104, "point format " + std::to_string(format) + " is not known; 0 to 10 are");
    header_.format = format;
    header_.record = at<std::uint16_t>(105);
    if (header_.record < las_record_sizes[format])
      fail(105, "a point record of " + std::to_string(header_.record) +
                    " bytes is too short for format " + std::to_string(format));
  }

  void parse_grid() {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double scale = at<double>(131 + 8 * axis), offset = at<double>(155 + 8 * axis);
      if (!(scale > 0) || !std::isfinite(scale) || !std::isfinite(offset))
        fail(131 + 8 * axis,
             "scale and offset of the coordinates are no positive number and a "
             "number; the file is damaged");
      header_.grid.scale[axis] = scale;
      header_.grid.offset[axis] = offset;
    }
  }

  void parse_points() {
    header_.points = at<std::uint32_t>(107);
    if (header_.minor == 4)
      if (const auto wide = at<std::uint64_t>(247); wide != 0) header_.points = wide;
    header_.data = at<std::uint32_t>(96);
    if (header_.data < header_size_)
      fail(96, "the points would begin inside the header; the file is damaged");
    const std::uint64_t room =
        header_.data > input_.size() ? 0 : (input_.size() - header_.data) / header_.record;
    if (header_.points > room)
      fail(input_.size(), "the header claims " + std::to_string(header_.points) + " points, " +
                              std::to_string(room) +
                              " are there; the file is cut off, fetch it again");
  }

  // Looks through the variable length records for the description of extra bytes.
  void parse_records() {
    extra_offset_ = las_record_sizes[header_.format];
    const auto records = at<std::uint32_t>(100);
    std::uint64_t begin = header_size_;
    const std::uint64_t end = std::min<std::uint64_t>(header_.data, input_.size());
    for (std::uint32_t r = 0; r < records && begin + las_vlr_header <= end; ++r) {
      const std::uint64_t data = begin + las_vlr_header;
      const std::uint64_t size = at<std::uint16_t>(begin + 20);
      if (size > end - data) break;
      if (input_.text().substr(begin + 2, 9) == "LASF_Spec" &&
          at<std::uint16_t>(begin + 18) == extra_record_id)
        for (std::uint64_t d = data; d + las_extra_descriptor <= data + size;
             d += las_extra_descriptor)
          add_extra(d);
      begin = data + size;
    }
    if (extra_offset_ < header_.record)
      report_.skipped.push_back(std::to_string(header_.record - extra_offset_) +
                                " bytes of every point that nothing describes");
  }

  void add_extra(std::uint64_t descriptor) {
    const auto type = at<std::uint8_t>(descriptor + 2);
    const auto options = at<std::uint8_t>(descriptor + 3);
    std::string name(input_.text().substr(descriptor + 4, 32));
    name.resize(std::min(name.find('\0'), name.size()));
    const bool known = type >= 1 && type <= last_array_type;
    const auto base = static_cast<std::uint8_t>(known ? (type - 1) % type_count + 1 : 0);
    const std::size_t numbers = known ? (type - 1u) / type_count + 1 : 1;
    const std::size_t size = known ? type_sizes[base] : options;
    if (size * numbers > header_.record - std::min(extra_offset_, header_.record))
      fail(descriptor, "the extra bytes do not fit into the point record; the file is damaged");
    if (header_.extras.size() + numbers > max_columns)
      fail(descriptor, "more than " + std::to_string(max_columns) + " extra numbers a point");
    if (!known) report_.skipped.push_back("extra bytes " + name);
    for (std::size_t n = 0; known && n < numbers; ++n) {
      LasExtra extra{numbers == 1 ? name : name + "_" + std::to_string(n), base,
                     extra_offset_ + n * size};
      if (options & scale_flag) extra.scale = at<double>(descriptor + 112 + 8 * n);
      if (options & shift_flag) extra.shift = at<double>(descriptor + 136 + 8 * n);
      header_.extras.push_back(extra);
    }
    extra_offset_ += size * numbers;
  }

  const InputBytes& input_;
  ReadReport& report_;
  LasHeader header_;
  std::size_t header_size_ = 0;
  std::size_t extra_offset_ = 0;  // in the point record, behind what is described so far
};

}  // namespace

double LasExtra::get(const std::byte* point) const {
  const std::byte* from = point + offset;
  double stored = 0;
  if (type == uint64_type)
    stored = static_cast<double>(load<std::uint64_t>(from));
  else if (type == int64_type)
    stored = static_cast<double>(load<std::int64_t>(from));
  else
    stored = load_scalar(from, scalar_types[type], ByteOrder::little);
  return scale == 1 && shift == 0 ? stored : stored * scale + shift;
}

ScalarType LasExtra::scalar_type() const {
  return scale == 1 && shift == 0 ? scalar_types[type] : ScalarType::float64;
}

LasHeader parse_las_header(const InputBytes& input, ReadReport& report) {
  return LasHeaderParser(input, report).parse();
}

}  // namespace spigolo
