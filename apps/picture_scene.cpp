// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// apps/picture_scene.cpp
#include "picture_scene.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>
#include <vector>

#include "feature_cloud.h"
#include "spigolo/core/error.h"
#include "suggest.h"

namespace spigolo {
namespace {

constexpr double bead_share = 0.012;  // size of a bead to that of the picture
constexpr double kept = 0.98;  // share of the values the colours span; strays take the end colours

// kind, rgb, none or the name of an attribute, for what the user wrote.
std::string settled(const PointCloud& cloud, const std::string& color) {
  if (color != "auto") return color;
  const bool rgb = cloud.find("red") && cloud.find("green") && cloud.find("blue");
  if (cloud.find("scalar_kind")) return "kind";
  if (cloud.find("scalar_deviation")) return "scalar_deviation";
  if (rgb) return "rgb";
  return cloud.find("truth_kind") ? "kind" : "none";
}

const Attribute& need(const PointCloud& cloud, const std::string& name) {
  if (const Attribute* found = cloud.find(name)) return *found;
  std::vector<std::string> names = {"auto", "kind", "rgb", "none"};
  for (const Attribute& a : cloud.attributes) names.push_back(a.name);
  throw UsageError("there is no '" + name + "' to colour by; the file has: " + joined(names));
}

std::vector<Color> own_colors(const PointCloud& cloud) {
  const Attribute &r = need(cloud, "red"), &g = need(cloud, "green"), &b = need(cloud, "blue");
  // Some writers store colours as floats in 0..1, LAS as 16 bits.
  const double scale = r.type == ScalarType::uint16                                     ? 1 / 257.0
                       : r.type == ScalarType::float32 || r.type == ScalarType::float64 ? 255.0
                                                                                        : 1.0;
  const auto channel = [&](double value) {
    return static_cast<std::uint8_t>(std::isnan(value) ? 0.0
                                                       : std::clamp(value * scale, 0.0, 255.0));
  };
  std::vector<Color> colors(cloud.size());
  for (std::size_t i = 0; i < colors.size(); ++i)
    colors[i] = {channel(r.values[i]), channel(g.values[i]), channel(b.values[i])};
  return colors;
}

// Signed values get blue - white - red around zero, others dark to bright.
ColorBar bar_for(const Attribute& attribute, const SceneOptions& options) {
  std::vector<double> values;
  std::copy_if(attribute.values.begin(), attribute.values.end(), std::back_inserter(values),
               [](double v) { return std::isfinite(v); });
  std::sort(values.begin(), values.end());
  ColorBar bar{ColorMap::sequential, 0, 1, attribute.name};
  if (!values.empty()) {
    const auto last = static_cast<double>(values.size() - 1);
    bar.low = values[static_cast<std::size_t>((1 - kept) * last)];
    bar.high = values[static_cast<std::size_t>(std::ceil(kept * last))];
  }
  if (options.range) std::tie(bar.low, bar.high) = *options.range;
  if (bar.low < 0 && bar.high > 0) {
    bar.map = ColorMap::diverging;
    bar.high = std::max(-bar.low, bar.high);
    bar.low = -bar.high;
  }
  if (!(bar.low < bar.high)) bar.high = bar.low + 1;
  return bar;
}

const Attribute& kind_attribute(const PointCloud& cloud) {
  const bool truth = !cloud.find("scalar_kind") && cloud.find("truth_kind");
  return need(cloud, truth ? "truth_kind" : "scalar_kind");
}

void add_colored(Scene& scene, const TriangleMesh& mesh, std::vector<Color> colors) {
  if (mesh.triangles.empty()) {
    PointLayer& layer = scene.points.emplace_back();
    layer.points = mesh.vertices.points;
    layer.colors = std::move(colors);
  } else {
    scene.meshes.back().colors = std::move(colors);
  }
}

}  // namespace

Scene make_scene(const TriangleMesh& mesh, const SceneOptions& options) {
  Scene scene;
  const PointCloud& cloud = mesh.vertices;
  if (!mesh.triangles.empty()) add_mesh(scene, mesh, options.smooth, options.wireframe);
  const std::string color = settled(cloud, options.color);
  if (color == "kind" && mesh.triangles.empty()) {
    add_points_by_kind(scene, cloud.points, kinds_of(kind_attribute(cloud)));
  } else if (color == "none" || color == "kind") {
    add_colored(scene, mesh, {});
  } else if (color == "rgb") {
    add_colored(scene, mesh, own_colors(cloud));
  } else {
    const Attribute& attribute = need(cloud, color);
    scene.color_bar = bar_for(attribute, options);
    add_colored(scene, mesh, colors_of(attribute.values, *scene.color_bar));
  }
  return scene;
}

Scene make_line_scene(const std::vector<Vec3>& vertices, const FileLines& lines) {
  Scene scene;
  LineLayer& layer = scene.lines.emplace_back();
  std::vector<std::size_t> ends(vertices.size(), 0);
  for (const auto& line : lines) {
    auto& points = layer.lines.emplace_back();
    for (const std::uint32_t v : line) points.push_back(vertices[v]);
    layer.colors.push_back(curve_color(layer.colors.size()));
    const bool closed = line.front() == line.back();
    if (!closed) ++ends[line.front()], ++ends[line.back()];
  }
  PointLayer beads;
  for (std::size_t v = 0; v < ends.size(); ++v)
    if (ends[v] > 0) beads.points.push_back(vertices[v]);
  beads.color = kind_color(PointKind::corner);
  beads.style = PointStyle::beads;
  const Vec3 size = bounding_box(vertices).size();
  beads.spacing = bead_share * std::max({size.x, size.y, size.z});
  scene.legend.push_back(
      {"curves", layer.colors.empty() ? beads.color : layer.colors.front(), lines.size()});
  if (!beads.points.empty()) {
    scene.legend.push_back({"ends and corners", beads.color, beads.points.size()});
    scene.points.push_back(std::move(beads));
  }
  return scene;
}

void merge(Scene& scene, Scene more) {
  const auto append = [](auto& to, auto& from) {
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
  };
  append(scene.points, more.points);
  append(scene.meshes, more.meshes);
  append(scene.lines, more.lines);
  append(scene.legend, more.legend);
  if (!scene.color_bar) scene.color_bar = more.color_bar;
}

}  // namespace spigolo
