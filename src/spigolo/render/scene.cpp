// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/scene.cpp
#include "spigolo/render/scene.h"

#include "spigolo/core/error.h"

namespace spigolo {
namespace {

void require(bool sound, const char* what) {
  if (!sound) throw UsageError(std::string("a scene cannot be drawn: ") + what);
}

}  // namespace

void add_points_by_kind(Scene& scene, std::span<const Vec3> points,
                        std::span<const PointKind> kinds) {
  require(points.size() == kinds.size(), "one kind is needed for each point");
  std::array<std::vector<Vec3>, point_kinds> of_kind;
  for (std::size_t i = 0; i < points.size(); ++i)
    of_kind[static_cast<std::size_t>(kinds[i])].push_back(points[i]);
  PointLayer& surface = scene.points.emplace_back();
  surface.points.assign(points.begin(), points.end());
  for (std::size_t k = 0; k < point_kinds; ++k) {
    if (of_kind[k].empty()) continue;
    const auto kind = static_cast<PointKind>(k);
    scene.legend.push_back({point_kind_names[k], kind_color(kind), of_kind[k].size()});
    if (kind == PointKind::surface) continue;
    // Corners and tips are few: larger, or nobody finds them.
    const double size = kind == PointKind::corner || kind == PointKind::tip ? 1.7 : 1.0;
    scene.points.push_back(
        {std::move(of_kind[k]), {}, kind_color(kind), PointStyle::beads, size, 0});
  }
}

void add_mesh(Scene& scene, const TriangleMesh& mesh, bool smooth, bool wireframe) {
  scene.meshes.push_back({mesh.vertices.points, mesh.triangles, {}, mesh_color, smooth, wireframe});
}

std::vector<Color> colors_of(std::span<const double> values, const ColorBar& bar) {
  std::vector<Color> colors;
  colors.reserve(values.size());
  const double range = bar.high - bar.low;
  for (const double v : values)
    colors.push_back(map_color(bar.map, range > 0 ? (v - bar.low) / range : 0.5));
  return colors;
}

std::vector<std::span<const Vec3>> positions_of(const Scene& scene) {
  std::vector<std::span<const Vec3>> spans;
  for (const PointLayer& layer : scene.points) spans.emplace_back(layer.points);
  for (const MeshLayer& layer : scene.meshes) spans.emplace_back(layer.points);
  for (const LineLayer& layer : scene.lines)
    for (const auto& line : layer.lines) spans.emplace_back(line);
  return spans;
}

void validate(const Scene& scene) {
  for (const PointLayer& layer : scene.points) {
    require(layer.colors.empty() || layer.colors.size() == layer.points.size(),
            "a point layer needs one colour per point or none");
    require(layer.size > 0 && layer.spacing >= 0, "point sizes must be positive");
  }
  for (const MeshLayer& layer : scene.meshes) {
    require(layer.colors.empty() || layer.colors.size() == layer.points.size(),
            "a mesh layer needs one colour per vertex or none");
    for (const auto& t : layer.triangles)
      for (const std::uint32_t v : t)
        require(v < layer.points.size(), "a triangle names a vertex that does not exist");
  }
  for (const LineLayer& layer : scene.lines) {
    require(layer.colors.empty() || layer.colors.size() == layer.lines.size(),
            "a line layer needs one colour per line or none");
    require(layer.width > 0, "line widths must be positive");
  }
}

}  // namespace spigolo
