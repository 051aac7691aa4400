// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/scene.h - what is to be seen: layers of points, triangles and lines
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "spigolo/core/features.h"
#include "spigolo/core/geometry.h"
#include "spigolo/core/triangle_mesh.h"
#include "spigolo/render/palette.h"

namespace spigolo {

/// How points are drawn. surface: splats that close up to a smooth surface. beads: small balls that
/// stand out of the surface they lie on, each in its own colour.
enum class PointStyle : std::uint8_t { surface, beads };

/// Points that are not finite are skipped.
struct PointLayer {
  std::vector<Vec3> points;
  std::vector<Color> colors;  // one per point, or empty: all as `color`
  Color color = kind_color(PointKind::surface);
  PointStyle style = PointStyle::surface;
  double size = 1;     // radius relative to the automatic one
  double spacing = 0;  // [model unit] of the sampling; 0: found from this layer's points
};

/// Triangles with a vertex that is not finite are skipped.
struct MeshLayer {
  std::vector<Vec3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<Color> colors;  // one per vertex, or empty: all as `color`
  Color color = mesh_color;
  bool smooth = false;     // shaded by vertex normals rather than flat
  bool wireframe = false;  // triangle edges drawn as thin dark lines
};

/// A line breaks where a vertex is not finite.
struct LineLayer {
  std::vector<std::vector<Vec3>> lines;
  std::vector<Color> colors;  // one per line, or empty: all as `color`
  Color color = kind_color(PointKind::edge);
  double width = 4;  // [pixel of the picture]
};

/// One row of the legend: a dot, a word and how many there are.
struct LegendEntry {
  std::string label;
  Color color;
  std::optional<std::size_t> count;
};

/// A vertical bar that explains the colours of a scalar.
struct ColorBar {
  ColorMap map = ColorMap::diverging;
  double low = -1, high = 1;  // values at the ends
  std::string label;
};

struct Scene {
  std::vector<PointLayer> points;
  std::vector<MeshLayer> meshes;
  std::vector<LineLayer> lines;
  std::vector<LegendEntry> legend;
  std::optional<ColorBar> color_bar;
};

/// Adds a cloud coloured by kind: the whole cloud as surface, features as beads, and a legend row
/// for each kind that occurs. kinds: one per point. Throws UsageError if the sizes differ.
void add_points_by_kind(Scene& scene, std::span<const Vec3> points,
                        std::span<const PointKind> kinds);

/// Adds a mesh without colours.
void add_mesh(Scene& scene, const TriangleMesh& mesh, bool smooth = false, bool wireframe = false);

/// One colour per value by the bar's map and range; sets nothing in a scene. Use it for the colours
/// of a layer and give the same bar to the scene.
std::vector<Color> colors_of(std::span<const double> values, const ColorBar& bar);

/// Every position of the scene, layer by layer: views, valid while the scene is.
std::vector<std::span<const Vec3>> positions_of(const Scene& scene);

/// Throws UsageError unless colours fit their layers and triangles name vertices that exist.
void validate(const Scene& scene);

}  // namespace spigolo
