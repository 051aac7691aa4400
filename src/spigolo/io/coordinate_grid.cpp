// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/io/coordinate_grid.cpp
#include "spigolo/io/coordinate_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spigolo {
namespace {

constexpr int most_decimals = 18;
constexpr double largest_whole = 0x1p52;  // whole numbers below have their own double
constexpr double lowest_integer = std::numeric_limits<std::int32_t>::min();
constexpr double highest_integer = std::numeric_limits<std::int32_t>::max();

// Multiplied up: exact to 10^22, the same on every machine.
double power_of_ten(int n) {
  double power = 1;
  for (int i = 0; i < n; ++i) power *= 10;
  return power;
}

bool keeps_all(const GridAxis& grid, std::span<const Vec3> points, std::size_t axis) {
  return std::all_of(points.begin(), points.end(), [&](const Vec3& p) {
    const auto integer = grid.encode(p[axis]);
    return integer && grid.decode(*integer) == p[axis];
  });
}

// An offset that brings both ends into reach: none if it can be.
double offset_for(double scale, double low, double high) {
  if (low >= lowest_integer * scale && high <= highest_integer * scale) return 0;
  const double middle = low / 2 + high / 2;
  return scale >= 1 ? std::round(middle / scale) * scale : std::round(middle);
}

bool reaches(const GridAxis& grid, double low, double high) {
  return grid.encode(low).has_value() && grid.encode(high).has_value();
}

}  // namespace

GridAxis::GridAxis(double scale, double offset) : scale_(scale), offset_(offset) {
  for (int n = 0; n <= most_decimals; ++n) {
    const double power = power_of_ten(n);
    if (scale != 1 / power) continue;
    const double whole = std::round(offset * power);
    if (std::abs(whole) >= largest_whole || whole / power != offset) return;
    power_ = power;
    whole_offset_ = whole;
  }
}

double GridAxis::decode(std::int32_t integer) const {
  if (power_ > 0) return (integer + whole_offset_) / power_;
  return integer * scale_ + offset_;
}

std::optional<std::int32_t> GridAxis::encode(double coordinate) const {
  const double integer = power_ > 0 ? std::round(coordinate * power_) - whole_offset_
                                    : std::round((coordinate - offset_) / scale_);
  if (!(integer >= lowest_integer && integer <= highest_integer)) return {};
  return static_cast<std::int32_t>(integer);
}

GridAxis choose_axis(std::span<const Vec3> points, std::size_t axis) {
  double low = infinity, high = -infinity;
  for (const Vec3& p : points) {
    low = std::min(low, p[axis]);
    high = std::max(high, p[axis]);
  }
  if (points.empty()) low = high = 0;
  std::optional<GridAxis> finest;
  for (int n = 0; n <= most_decimals; ++n) {
    const double scale = 1 / power_of_ten(n);
    const GridAxis grid(scale, offset_for(scale, low, high));
    if (!reaches(grid, low, high)) break;
    if (keeps_all(grid, points, axis)) return grid;
    finest = grid;
  }
  if (finest) return *finest;
  for (double scale = 10; scale < 0x1p1000; scale *= 10) {
    const GridAxis grid(scale, offset_for(scale, low, high));
    if (reaches(grid, low, high)) return grid;
  }
  return GridAxis(0x1p1000, 0);
}

}  // namespace spigolo
