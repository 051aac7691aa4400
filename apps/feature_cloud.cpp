// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/feature_cloud.cpp
#include "feature_cloud.h"

#include <utility>

#include "spigolo/render/palette.h"

namespace spigolo {
namespace {

// Adds a column with value(i) for point i.
template <typename F>
void add_column(PointCloud& cloud, const char* name, ScalarType type, const F& value) {
  std::vector<double> values(cloud.size());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = value(i);
  cloud.attributes.push_back({name, type, std::move(values)});
}

}  // namespace

PointCloud with_features(PointCloud cloud, const Features& f) {
  std::vector<Attribute> carried = std::exchange(cloud.attributes, {});
  const auto color = [&](std::size_t i) { return kind_color(f.kind[i]); };
  const auto point = [&](std::size_t i) -> const Vec3& { return f.crease_point[i]; };
  const auto is_float = ScalarType::float32;
  const auto is_double = ScalarType::float64;
  add_column(cloud, "red", ScalarType::uint8, [&](std::size_t i) { return color(i).r; });
  add_column(cloud, "green", ScalarType::uint8, [&](std::size_t i) { return color(i).g; });
  add_column(cloud, "blue", ScalarType::uint8, [&](std::size_t i) { return color(i).b; });
  add_column(cloud, "quality", is_float, [&](std::size_t i) { return f.strength[i]; });
  add_column(cloud, "scalar_kind", is_float,
             [&](std::size_t i) { return static_cast<double>(f.kind[i]); });
  add_column(cloud, "scalar_angle", is_float, [&](std::size_t i) { return degrees(f.angle[i]); });
  add_column(cloud, "scalar_convex", is_float, [&](std::size_t i) { return f.convex[i]; });
  add_column(cloud, "scalar_curve", is_float, [&](std::size_t i) { return f.curve[i]; });
  add_column(cloud, "edge_x", is_double, [&](std::size_t i) { return point(i).x; });
  add_column(cloud, "edge_y", is_double, [&](std::size_t i) { return point(i).y; });
  add_column(cloud, "edge_z", is_double, [&](std::size_t i) { return point(i).z; });
  for (Attribute& attribute : carried)
    if (!cloud.find(attribute.name)) cloud.attributes.push_back(std::move(attribute));
  return cloud;
}

std::vector<PointKind> kinds_of(const Attribute& attribute) {
  std::vector<PointKind> kinds(attribute.values.size(), PointKind::surface);
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const double value = attribute.values[i];
    if (value > 0 && value < static_cast<double>(point_kinds))
      kinds[i] = static_cast<PointKind>(static_cast<int>(value));
  }
  return kinds;
}

}  // namespace spigolo
