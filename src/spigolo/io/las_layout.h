// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/las_layout.h - where a LAS point record holds what
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "spigolo/core/point_cloud.h"

namespace spigolo {

inline constexpr std::uint8_t las_formats = 11;
inline constexpr std::array<std::size_t, las_formats> las_record_sizes = {20, 28, 26, 34, 57, 63,
                                                                          30, 36, 38, 59, 67};
/// Header sizes of LAS 1.0 to 1.4.
inline constexpr std::array<std::size_t, 5> las_header_sizes = {227, 227, 227, 235, 375};

inline constexpr std::size_t las_vlr_header = 54;         // bytes before the data of a record
inline constexpr std::size_t las_extra_descriptor = 192;  // bytes that describe one extra field

/// A scalar of a point record, whole or a few bits of its byte.
struct LasField {
  const char* name;
  ScalarType type;
  std::size_t offset;
  unsigned shift = 0, bits = 0;  // bits 0: the whole scalar

  /// The number in the record.
  double get(const std::byte* record) const;
  /// Puts a number that fits into the record, whose bits are still 0.
  void put(std::byte* record, double value) const;
  /// True if the value comes back equal.
  bool fits(double value) const;
};

/// The fields beside X, Y, Z of a point format in [0, 10]. Scan angles as they are stored:
/// scan_angle_rank in degrees (formats 0 to 5), scan_angle in 0.006 degrees.
std::vector<LasField> las_fields(std::uint8_t format);

/// True if the format carries wave packets, which are not read.
bool las_has_waves(std::uint8_t format);

}  // namespace spigolo
