// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/las_header.h - what a LAS file says about itself
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "spigolo/core/point_cloud.h"
#include "spigolo/io/input_bytes.h"
#include "spigolo/io/read_report.h"

namespace spigolo {

/// A number stored behind the standard fields, as the Extra Bytes record describes it.
struct LasExtra {
  std::string name;
  std::uint8_t type = 0;        // of the LAS specification: 1 uint8 ... 10 double
  std::size_t offset = 0;       // in the point record
  double scale = 1, shift = 0;  // value = stored * scale + shift

  double get(const std::byte* record) const;
  /// float64 for scaled values and 8-byte integers.
  ScalarType scalar_type() const;
};

struct LasHeader {
  int minor = 2;
  std::uint8_t format = 0;
  std::size_t record = 0;  // bytes of a point
  std::uint64_t points = 0;
  std::uint64_t data = 0;  // offset of the first point
  CoordinateGrid grid;
  std::vector<LasExtra> extras;
};

/// LAS 1.0 to 1.4. What of the extra bytes cannot be read is named in report.skipped.
/// Throws InputError if the header is damaged, if the points are compressed (LAZ), or if they do
/// not all lie in the file.
LasHeader parse_las_header(const InputBytes& input, ReadReport& report);

}  // namespace spigolo
