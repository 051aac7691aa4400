// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/ply_header.h - what a PLY file says about itself
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "spigolo/core/point_cloud.h"
#include "spigolo/io/input_bytes.h"
#include "spigolo/io/scalar.h"

namespace spigolo {

struct PlyProperty {
  std::string name;
  ScalarType type = ScalarType::float32;  // of the value, or of a list's entries
  std::optional<ScalarType> count_type;   // of a list's length; none: not a list

  bool is_list() const { return count_type.has_value(); }
};

struct PlyElementHeader {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;

  bool has_list() const;
  /// Bytes of one row in a binary file; lists count with their length field alone.
  std::size_t least_row_size() const;
};

struct PlyHeader {
  bool ascii = false;
  ByteOrder order = ByteOrder::little;
  std::vector<PlyElementHeader> elements;
  std::size_t body = 0;   // offset of the first byte behind the header
  std::size_t lines = 0;  // of the header
};

/// Takes both names of every type (char, int8 ...), comments, obj_info, and all three line ends.
/// Throws InputError at the line of the header that is wrong.
PlyHeader parse_ply_header(const InputBytes& input);

/// The name PLY has for a type.
const char* ply_type_name(ScalarType type);

}  // namespace spigolo
