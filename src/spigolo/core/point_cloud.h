// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/core/point_cloud.h - points with any number of named scalars
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "spigolo/core/geometry.h"

namespace spigolo {

/// How a scalar is stored in files; in memory every value is a double, which holds them all
/// exactly.
enum class ScalarType : std::uint8_t {
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  float32,
  float64
};

/// One named scalar per point.
struct Attribute {
  std::string name;  // as PLY writes it: "red", "quality", "scalar_kind", "nx"; no blanks, unique
  ScalarType type = ScalarType::float32;
  std::vector<double> values;  // one per point
};

/// What a scan is: positions, in any unit, possibly NaN or infinite, in the order of the file.
struct PointCloud {
  std::vector<Vec3> points;
  std::vector<Attribute> attributes;

  std::size_t size() const { return points.size(); }
  /// The attribute of that name, or null.
  const Attribute* find(std::string_view name) const;
  /// Sets (adds or replaces) an attribute; values has one entry per point.
  void set(std::string name, ScalarType type, std::vector<double> values);
};

/// Throws Error unless every attribute has a unique non-empty name without blanks and one value per
/// point. Positions may be anything.
void validate(const PointCloud& cloud);

}  // namespace spigolo
