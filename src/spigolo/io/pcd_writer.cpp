// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/pcd_writer.cpp
#include "spigolo/io/pcd_writer.h"

#include <algorithm>
#include <bit>
#include <functional>
#include <limits>

#include "spigolo/io/colours.h"
#include "spigolo/io/lzf.h"
#include "spigolo/io/names.h"
#include "spigolo/io/scalar.h"
#include "spigolo/io/text.h"

namespace spigolo {
namespace {

constexpr std::size_t block_rows = 4096;

struct Column {
  std::string name;
  ScalarType type;
  std::function<double(std::size_t)> value;
  bool packed = false;  // values are the bits of a float
};

bool fits_float(const PointCloud& cloud) {
  const auto exact = [](double v) {
    return std::isnan(v) || static_cast<double>(narrow<float>(v)) == v;
  };
  return std::all_of(cloud.points.begin(), cloud.points.end(),
                     [&](const Vec3& p) { return exact(p.x) && exact(p.y) && exact(p.z); });
}

double packed_colour(const std::vector<const Attribute*>& colours, std::size_t i) {
  std::uint32_t bits = 0;
  for (const Attribute* c : colours) bits = bits << 8 | narrow<std::uint8_t>(c->values[i]);
  return bits;
}

std::vector<Column> columns_of(const PointCloud& cloud) {
  std::vector<Column> columns;
  const ScalarType position = fits_float(cloud) ? ScalarType::float32 : ScalarType::float64;
  for (std::size_t axis = 0; axis < 3; ++axis)
    columns.push_back({std::string(1, "xyz"[axis]), position,
                       [&cloud, axis](std::size_t i) { return cloud.points[i][axis]; }});
  const std::vector<const Attribute*> colours = find_colours(cloud);
  const std::vector<std::string> names = file_names(cloud);
  for (std::size_t a = 0; a < names.size(); ++a) {
    const Attribute& attribute = cloud.attributes[a];
    if (!colours.empty() && &attribute == colours[0])
      columns.push_back({"rgb", ScalarType::uint32,
                         [colours](std::size_t i) { return packed_colour(colours, i); }, true});
    else if (std::find(colours.begin(), colours.end(), &attribute) == colours.end())
      columns.push_back(
          {names[a], attribute.type, [&attribute](std::size_t i) { return attribute.values[i]; }});
  }
  return columns;
}

std::string header_text(const std::vector<Column>& columns, std::size_t points,
                        const char* encoding) {
  std::string fields = "FIELDS", sizes = "SIZE", types = "TYPE", counts = "COUNT";
  for (const Column& c : columns) {
    fields += " " + c.name;
    sizes += " " + std::to_string(size_of(c.type));
    const bool has_sign =
        c.type == ScalarType::int8 || c.type == ScalarType::int16 || c.type == ScalarType::int32;
    types += !is_integer(c.type) || c.packed ? " F" : has_sign ? " I" : " U";
    counts += " 1";
  }
  const std::string n = std::to_string(points);
  return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n" + fields + "\n" + sizes +
         "\n" + types + "\n" + counts + "\nWIDTH " + n + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\n" +
         "POINTS " + n + "\nDATA " + encoding + "\n";
}

void write_ascii(AtomicFile& out, const std::vector<Column>& columns, std::size_t points) {
  std::string line;
  for (std::size_t i = 0; i < points; ++i) {
    line.clear();
    for (const Column& c : columns) {
      const double value = c.value(i);
      if (c.packed)
        append_number(line, std::bit_cast<float>(narrow<std::uint32_t>(value)),
                      ScalarType::float32);
      else
        append_number(line, value, c.type);
      line += ' ';
    }
    line.back() = '\n';
    out.write(line);
  }
}

std::size_t row_size(const std::vector<Column>& columns) {
  std::size_t size = 0;
  for (const Column& c : columns) size += size_of(c.type);
  return size;
}

void write_binary(AtomicFile& out, const std::vector<Column>& columns, std::size_t points) {
  const std::size_t stride = row_size(columns);
  std::vector<std::byte> block(std::min(points, block_rows) * stride);
  for (std::size_t begin = 0; begin < points; begin += block_rows) {
    const std::size_t count = std::min(block_rows, points - begin);
    std::byte* to = block.data();
    for (const Column& c : columns) {
      store_column(to, stride, c.type, count, [&](std::size_t i) { return c.value(begin + i); });
      to += size_of(c.type);
    }
    out.write({reinterpret_cast<const char*>(block.data()), count * stride});
  }
}

void write_compressed(AtomicFile& out, const std::vector<Column>& columns, std::size_t points,
                      const std::vector<std::byte>& packed) {
  std::byte sizes[8];
  store(sizes, static_cast<std::uint32_t>(packed.size()));
  store(sizes + 4, static_cast<std::uint32_t>(points * row_size(columns)));
  out.write({reinterpret_cast<const char*>(sizes), sizeof sizes});
  out.write({reinterpret_cast<const char*>(packed.data()), packed.size()});
}

// The columns one behind the other, compressed.
std::vector<std::byte> compress(const std::vector<Column>& columns, std::size_t points) {
  std::vector<std::byte> plain(points * row_size(columns));
  std::byte* to = plain.data();
  for (const Column& c : columns) {
    store_column(to, size_of(c.type), c.type, points, c.value);
    to += points * size_of(c.type);
  }
  return lzf_compress(plain);
}

}  // namespace

void write_pcd(AtomicFile& out, const PointCloud& cloud, const WriteOptions& options) {
  validate(cloud);
  const std::vector<Column> columns = columns_of(cloud);
  const std::size_t points = cloud.size();
  // A stream may be a 32nd longer than its data; both lengths must fit into 32 bits.
  constexpr std::size_t longest = std::numeric_limits<std::uint32_t>::max() / 33 * 32;
  const bool compressed = options.compressed && points * row_size(columns) <= longest;
  out.write(header_text(columns, points,
                        options.ascii ? "ascii"
                        : compressed  ? "binary_compressed"
                                      : "binary"));
  if (options.ascii)
    write_ascii(out, columns, points);
  else if (compressed)
    write_compressed(out, columns, points, compress(columns, points));
  else
    write_binary(out, columns, points);
}

}  // namespace spigolo
