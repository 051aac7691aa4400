// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/ply_body.h - the rows of a PLY file, element after element
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "spigolo/io/ply_header.h"
#include "spigolo/io/text.h"

namespace spigolo {

/// Stands at the first row of an element; each call reads or steps over one whole element.
/// All throw InputError if the bytes end early or a number is none.
class PlyBody {
 public:
  PlyBody(const InputBytes& input, const PlyHeader& header);

  /// One column a property, count values each; lists are stepped over and get an empty column.
  std::vector<std::vector<double>> read_columns(const PlyElementHeader& element);
  /// Calls visit with the list `property` of every row, as vertex indices.
  void read_lists(const PlyElementHeader& element, std::size_t property,
                  const std::function<void(std::span<const std::uint32_t>)>& visit);
  void skip(const PlyElementHeader& element);

  /// True when nothing but blank space (ascii) or nothing at all (binary) is left.
  bool at_end();

  // How single numbers are read or stepped over.
  class BinaryWalker;
  class AsciiWalker;

 private:
  void check_room(const PlyElementHeader& element);
  std::vector<std::vector<double>> read_fixed_rows(const PlyElementHeader& element);

  InputBytes input_;
  bool ascii_;
  ByteOrder order_;
  std::size_t at_;    // binary: offset of the next byte
  WordReader words_;  // ascii
};

}  // namespace spigolo
