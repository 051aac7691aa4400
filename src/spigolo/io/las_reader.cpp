// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/las_reader.cpp
#include "spigolo/io/las_reader.h"

#include <algorithm>
#include <utility>

#include "spigolo/io/coordinate_grid.h"
#include "spigolo/io/las_header.h"
#include "spigolo/io/las_layout.h"
#include "spigolo/io/names.h"
#include "spigolo/io/scalar.h"

namespace spigolo {
namespace {

std::vector<Vec3> read_points(const std::byte* first, const LasHeader& header) {
  std::vector<Vec3> points(header.points);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const GridAxis grid(header.grid.scale[axis], header.grid.offset[axis]);
    for (std::size_t i = 0; i < points.size(); ++i)
      points[i][axis] =
          grid.decode(load<std::int32_t>(first + i * header.record + sizeof(std::int32_t) * axis));
  }
  return points;
}

// Field: LasField or LasExtra.
template <class Field>
std::vector<double> read_field(const std::byte* first, const LasHeader& header,
                               const Field& field) {
  std::vector<double> values(header.points);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = field.get(first + i * header.record);
  return values;
}

}  // namespace

PointCloud read_las(const InputBytes& input, ReadReport& report) {
  const LasHeader header = parse_las_header(input, report);
  report.format = "las";
  report.encoding = "binary_little_endian";
  report.version =
      "1." + std::to_string(header.minor) + ", point format " + std::to_string(header.format);
  report.points = header.points;
  report.grid = header.grid;
  if (las_has_waves(header.format)) report.skipped.push_back("wave packets");
  PointCloud cloud;
  if (header.points == 0) return cloud;
  const std::byte* first = input.bytes.data() + header.data;
  cloud.points = read_points(first, header);
  UniqueNames unique{"x", "y", "z"};
  for (const LasField& field : las_fields(header.format)) {
    std::vector<double> values = read_field(first, header, field);
    if (std::all_of(values.begin(), values.end(), [](double v) { return v == 0; })) continue;
    cloud.attributes.push_back({unique(field.name), field.type, std::move(values)});
  }
  for (const LasExtra& extra : header.extras)
    cloud.attributes.push_back(
        {unique(extra.name), extra.scalar_type(), read_field(first, header, extra)});
  return cloud;
}

}  // namespace spigolo
