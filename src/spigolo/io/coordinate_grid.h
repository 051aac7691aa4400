// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/coordinate_grid.h - coordinates as 32-bit integers, without loss where that is
// possible
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "spigolo/core/geometry.h"
#include "spigolo/io/read_report.h"

namespace spigolo {

/// One axis of a grid. With a scale of 10^-n and an offset that is a multiple of it, integers turn
/// into the doubles nearest to their decimals: 6123456789 * 0.001 gives what the text 6123456.789
/// gives, where multiplying would be off by a bit.
class GridAxis {
 public:
  /// scale: positive and finite; offset: finite.
  GridAxis(double scale, double offset);

  double decode(std::int32_t integer) const;
  /// The integer nearest to a finite coordinate; none if it is out of range.
  std::optional<std::int32_t> encode(double coordinate) const;

  double scale() const { return scale_; }
  double offset() const { return offset_; }

 private:
  double scale_, offset_;
  double power_ = 0;         // 10^n if the axis is decimal, else 0
  double whole_offset_ = 0;  // offset * 10^n, a whole number
};

/// An axis that takes all the coordinates (finite ones): the coarsest power of ten that keeps each
/// to the last bit, else the finest that reaches.
GridAxis choose_axis(std::span<const Vec3> points, std::size_t axis);

}  // namespace spigolo
