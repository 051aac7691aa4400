// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/feature_cloud.cpp
#include "feature_cloud.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "spigolo/core/error.h"
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
  add_column(cloud, "scalar_sheets", is_float, [&](std::size_t i) { return f.sheets[i]; });
  add_column(cloud, "direction_x", is_float, [&](std::size_t i) { return f.direction[i].x; });
  add_column(cloud, "direction_y", is_float, [&](std::size_t i) { return f.direction[i].y; });
  add_column(cloud, "direction_z", is_float, [&](std::size_t i) { return f.direction[i].z; });
  for (Attribute& attribute : carried)
    if (!cloud.find(attribute.name)) cloud.attributes.push_back(std::move(attribute));
  return cloud;
}

namespace {

void check_same_points(const PointCloud& labels, const PointCloud& cloud, const std::string& file) {
  const std::string remedy = "; label these points with 'spigolo detect'";
  if (labels.size() != cloud.size())
    throw InputError(file, "",
                     "it holds labels of another cloud: " + std::to_string(labels.size()) +
                         " points, not " + std::to_string(cloud.size()) + remedy);
  const double tolerance = 1e-6 * norm(bounding_box(cloud.points).size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Vec3 &a = labels.points[i], &b = cloud.points[i];
    const bool same = is_finite(a) ? distance(a, b) <= tolerance : !is_finite(b);
    if (!same)
      throw InputError(
          file, "point " + std::to_string(i),
          "it holds labels of another cloud: the point is not where the cloud has it" + remedy);
  }
}

// value(i) of an attribute, or of another one if there is none.
double value_of(const Attribute* attribute, std::size_t i, double otherwise) {
  return attribute == nullptr || std::isnan(attribute->values[i]) ? otherwise
                                                                  : attribute->values[i];
}

}  // namespace

Features features_of(const PointCloud& labels, const PointCloud& cloud, const std::string& file) {
  const Attribute* kind = labels.find("scalar_kind");
  if (kind == nullptr)
    throw InputError(
        file, "header",
        "it has no property scalar_kind, so no labels; make them with 'spigolo detect'");
  check_same_points(labels, cloud, file);
  const Attribute *quality = labels.find("quality"), *angle = labels.find("scalar_angle"),
                  *convex = labels.find("scalar_convex"), *curve = labels.find("scalar_curve"),
                  *x = labels.find("edge_x"), *y = labels.find("edge_y"),
                  *z = labels.find("edge_z"), *u = labels.find("direction_x"),
                  *v = labels.find("direction_y"), *w = labels.find("direction_z");
  const bool has_creases = x && y && z && u && v && w;
  Features f;
  f.assign_surface(labels.size());
  f.kind = kinds_of(*kind);
  for (std::size_t i = 0; i < f.size(); ++i) {
    if (f.kind[i] == PointKind::surface) continue;
    const Vec3& p = cloud.points[i];
    f.strength[i] = static_cast<float>(std::clamp(value_of(quality, i, 1), 0.0, 1.0));
    if (f.kind[i] != PointKind::border)
      f.angle[i] = std::clamp(radians(value_of(angle, i, 0)), 0.0, pi);
    const double side = value_of(convex, i, 0);
    f.convex[i] = static_cast<std::int8_t>(side > 0 ? 1 : side < 0 ? -1 : 0);
    f.curve[i] = static_cast<std::int32_t>(std::clamp(value_of(curve, i, -1), -1.0, 2e9));
    f.crease_point[i] = {value_of(x, i, p.x), value_of(y, i, p.y), value_of(z, i, p.z)};
    if (has_creases && f.kind[i] == PointKind::edge) {
      const Vec3 direction{value_of(u, i, 0), value_of(v, i, 0), value_of(w, i, 0)};
      if (is_finite(direction) && norm(direction) > 0.5) f.direction[i] = normalized(direction);
    }
    f.sheets[i] = f.kind[i] == PointKind::edge ? 2 : f.kind[i] == PointKind::corner ? 3 : 1;
  }
  return f;
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
