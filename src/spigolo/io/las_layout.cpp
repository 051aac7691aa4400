// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/las_layout.cpp
#include "spigolo/io/las_layout.h"

#include <cmath>

#include "spigolo/io/scalar.h"

namespace spigolo {
namespace {

using enum ScalarType;

const std::vector<LasField> legacy_fields = {{"intensity", uint16, 12},
                                             {"return_number", uint8, 14, 0, 3},
                                             {"number_of_returns", uint8, 14, 3, 3},
                                             {"scan_direction", uint8, 14, 6, 1},
                                             {"edge_of_flight_line", uint8, 14, 7, 1},
                                             {"classification", uint8, 15, 0, 5},
                                             {"synthetic", uint8, 15, 5, 1},
                                             {"key_point", uint8, 15, 6, 1},
                                             {"withheld", uint8, 15, 7, 1},
                                             {"scan_angle_rank", int8, 16},
                                             {"user_data", uint8, 17},
                                             {"point_source_id", uint16, 18}};

const std::vector<LasField> modern_fields = {{"intensity", uint16, 12},
                                             {"return_number", uint8, 14, 0, 4},
                                             {"number_of_returns", uint8, 14, 4, 4},
                                             {"synthetic", uint8, 15, 0, 1},
                                             {"key_point", uint8, 15, 1, 1},
                                             {"withheld", uint8, 15, 2, 1},
                                             {"overlap", uint8, 15, 3, 1},
                                             {"scanner_channel", uint8, 15, 4, 2},
                                             {"scan_direction", uint8, 15, 6, 1},
                                             {"edge_of_flight_line", uint8, 15, 7, 1},
                                             {"classification", uint8, 16},
                                             {"user_data", uint8, 17},
                                             {"scan_angle", int16, 18},
                                             {"point_source_id", uint16, 20},
                                             {"gps_time", float64, 22}};

}  // namespace

double LasField::get(const std::byte* record) const {
  const double whole = load_scalar(record + offset, type, ByteOrder::little);
  if (bits == 0) return whole;
  return static_cast<unsigned>(whole) >> shift & ((1u << bits) - 1);
}

void LasField::put(std::byte* record, double value) const {
  if (bits == 0)
    store_column(record + offset, 0, type, 1, [&](std::size_t) { return value; });
  else
    record[offset] |= static_cast<std::byte>(static_cast<unsigned>(value) << shift);
}

bool LasField::fits(double value) const {
  if (bits > 0) return value >= 0 && value < (1u << bits) && value == std::floor(value);
  return with_type(type, [&](auto tag) {
    return static_cast<double>(narrow<decltype(tag)>(value)) == value ||
           (!is_integer(type) && std::isnan(value));
  });
}

std::vector<LasField> las_fields(std::uint8_t format) {
  const bool modern = format >= 6;
  std::vector<LasField> fields = modern ? modern_fields : legacy_fields;
  const bool has_time = !modern && (format == 1 || format >= 3);
  if (has_time) fields.push_back({"gps_time", float64, 20});
  std::size_t colour = 0;
  if (format == 2) colour = 20;
  if (format == 3 || format == 5) colour = 28;
  if (format == 7 || format == 8 || format == 10) colour = 30;
  if (colour > 0) {
    fields.push_back({"red", uint16, colour});
    fields.push_back({"green", uint16, colour + 2});
    fields.push_back({"blue", uint16, colour + 4});
  }
  if (format == 8 || format == 10) fields.push_back({"nir", uint16, 36});
  return fields;
}

bool las_has_waves(std::uint8_t format) {
  return format == 4 || format == 5 || format == 9 || format == 10;
}

}  // namespace spigolo
