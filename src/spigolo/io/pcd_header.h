// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/pcd_header.h - what a PCD file says about itself
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "spigolo/io/input_bytes.h"

namespace spigolo {

enum class PcdData : std::uint8_t { ascii, binary, binary_compressed };

struct PcdField {
  std::string name;       // "_" is padding
  char type = 'F';        // I, U or F
  std::size_t size = 4;   // bytes: 1, 2, 4, 8; F: 4, 8
  std::size_t count = 1;  // numbers a point has of it
};

struct PcdHeader {
  std::string version;
  std::vector<PcdField> fields;
  std::uint64_t points = 0;
  PcdData data = PcdData::ascii;
  std::size_t body = 0;   // offset of the first byte behind the header
  std::size_t lines = 0;  // of the header

  std::size_t row_size() const;     // bytes of a point in binary
  std::size_t row_numbers() const;  // words of a point in ascii
};

/// Versions 0.5 to 0.7. Throws InputError at the line of the header that is wrong.
PcdHeader parse_pcd_header(const InputBytes& input);

}  // namespace spigolo
