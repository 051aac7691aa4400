// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/las_writer.cpp
#include "spigolo/io/las_writer.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include "spigolo/core/error.h"
#include "spigolo/io/coordinate_grid.h"
#include "spigolo/io/las_plan.h"
#include "spigolo/io/scalar.h"

namespace spigolo {
namespace {

constexpr std::size_t block_rows = 4096;
constexpr std::uint16_t wkt_flag = 16;  // point formats from 6 on promise their reference as text
constexpr std::array<std::uint8_t, 8> extra_types = {2, 1, 4, 3, 6, 5, 9, 10};  // by ScalarType

using Grid = std::array<GridAxis, 3>;

bool takes_all(const GridAxis& grid, const std::vector<Vec3>& points, std::size_t axis) {
  return std::all_of(points.begin(), points.end(),
                     [&](const Vec3& p) { return grid.encode(p[axis]).has_value(); });
}

Grid choose_grid(const PointCloud& cloud, const WriteOptions& options, WriteReport& report) {
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (!is_finite(cloud.points[i]))
      throw UsageError("LAS holds no NaN or infinite coordinates and point " + std::to_string(i) +
                       " has one; write .ply instead");
  Grid grid = {GridAxis(1, 0), GridAxis(1, 0), GridAxis(1, 0)};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const bool given = options.grid && options.grid->scale[axis] > 0;
    if (given) grid[axis] = GridAxis(options.grid->scale[axis], options.grid->offset[axis]);
    if (!given || !takes_all(grid[axis], cloud.points, axis))
      grid[axis] = choose_axis(cloud.points, axis);
    for (const Vec3& p : cloud.points)
      report.rounding =
          std::max(report.rounding,
                   std::abs(grid[axis].decode(grid[axis].encode(p[axis]).value_or(0)) - p[axis]));
  }
  return grid;
}

// How many points are the first, second ... return of their pulse.
std::array<std::uint64_t, 15> count_returns(const LasPlan& plan) {
  std::array<std::uint64_t, 15> counts{};
  for (const LasColumn& c : plan.columns) {
    if (std::strcmp(c.field.name, "return_number") != 0) continue;
    for (const double v : c.attribute->values)
      if (v >= 1 && v <= 15) ++counts[static_cast<std::size_t>(v) - 1];
  }
  return counts;
}

// The header block of the version, with everything but the record of extra bytes.
std::vector<std::byte> header_bytes(const PointCloud& cloud, const LasPlan& plan,
                                    const Grid& grid) {
  std::vector<std::byte> h(las_header_sizes[static_cast<std::size_t>(plan.minor)]);
  const auto put = [&](std::size_t at, auto value) { store(h.data() + at, value); };
  const std::size_t records =
      plan.extras.empty() ? 0 : las_vlr_header + plan.extras.size() * las_extra_descriptor;
  std::memcpy(h.data(), "LASF", 4);
  put(6, plan.format >= 6 ? wkt_flag : std::uint16_t{0});
  put(24, std::uint8_t{1});
  put(25, static_cast<std::uint8_t>(plan.minor));
  std::memcpy(h.data() + 26, "spigolo", 7);  // system
  std::memcpy(h.data() + 58, "spigolo", 7);  // software
  put(94, static_cast<std::uint16_t>(h.size()));
  put(96, static_cast<std::uint32_t>(h.size() + records));
  put(100, static_cast<std::uint32_t>(plan.extras.empty() ? 0 : 1));
  put(104, plan.format);
  put(105, static_cast<std::uint16_t>(plan.record));
  // The old 32-bit counts stay 0 where the specification wants it.
  const bool old_counts =
      plan.format < 6 && cloud.size() <= std::numeric_limits<std::uint32_t>::max();
  const std::array<std::uint64_t, 15> returns = count_returns(plan);
  if (old_counts) {
    put(107, static_cast<std::uint32_t>(cloud.size()));
    for (std::size_t r = 0; r < 5; ++r) put(111 + 4 * r, static_cast<std::uint32_t>(returns[r]));
  }
  if (plan.minor == 4) {
    put(247, static_cast<std::uint64_t>(cloud.size()));
    for (std::size_t r = 0; r < 15; ++r) put(255 + 8 * r, returns[r]);
  }
  const Box box = bounding_box(cloud.points);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    put(131 + 8 * axis, grid[axis].scale());
    put(155 + 8 * axis, grid[axis].offset());
    put(179 + 16 * axis, box.empty() ? 0 : box.max[axis]);
    put(187 + 16 * axis, box.empty() ? 0 : box.min[axis]);
  }
  return h;
}

std::vector<std::byte> extra_record(const LasPlan& plan) {
  if (plan.extras.empty()) return {};
  const std::size_t size = plan.extras.size() * las_extra_descriptor;
  std::vector<std::byte> record(las_vlr_header + size);
  std::memcpy(record.data() + 2, "LASF_Spec", 9);
  store(record.data() + 18, std::uint16_t{4});
  store(record.data() + 20, static_cast<std::uint16_t>(size));
  std::byte* to = record.data() + las_vlr_header;
  for (const LasColumn& extra : plan.extras) {
    store(to + 2, extra_types[static_cast<std::size_t>(extra.attribute->type)]);
    const std::string& name = extra.attribute->name;
    std::memcpy(to + 4, name.data(), std::min<std::size_t>(name.size(), 32));
    to += las_extra_descriptor;
  }
  return record;
}

void write_bytes(AtomicFile& out, std::span<const std::byte> bytes) {
  out.write({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

void fill_record(std::byte* record, const PointCloud& cloud, const LasPlan& plan, const Grid& grid,
                 std::size_t i) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    store(record + 4 * axis, grid[axis].encode(cloud.points[i][axis]).value_or(0));
  for (const LasColumn& c : plan.columns) c.field.put(record, c.attribute->values[i] * c.factor);
  for (const LasColumn& c : plan.extras) c.field.put(record, c.attribute->values[i]);
}

}  // namespace

void write_las(AtomicFile& out, const PointCloud& cloud, const WriteOptions& options,
               WriteReport& report) {
  validate(cloud);
  const Grid grid = choose_grid(cloud, options, report);
  const LasPlan plan = plan_las(cloud, report);
  write_bytes(out, header_bytes(cloud, plan, grid));
  write_bytes(out, extra_record(plan));
  std::vector<std::byte> block;
  for (std::size_t begin = 0; begin < cloud.size(); begin += block_rows) {
    const std::size_t count = std::min(block_rows, cloud.size() - begin);
    block.assign(count * plan.record, std::byte{0});
    for (std::size_t i = 0; i < count; ++i)
      fill_record(block.data() + i * plan.record, cloud, plan, grid, begin + i);
    write_bytes(out, block);
  }
}

}  // namespace spigolo
