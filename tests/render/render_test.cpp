// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/render/render_test.cpp - pictures against what must be seen in them
#include "spigolo/render/render.h"

#include <gtest/gtest.h>

#include "spigolo/core/error.h"
#include "spigolo/core/random.h"
#include "spigolo/render/canvas.h"
#include "spigolo/render/overlay.h"
#include "spigolo/render/surfels.h"

namespace spigolo {
namespace {

RenderOptions bare(int side = 240) {
  RenderOptions o;
  o.width = o.height = side;
  o.top = o.bottom = {255, 255, 255};
  o.legend = o.scale_bar = o.axes = false;
  o.view.direction = Vec3{0, 1, 0};
  o.view.perspective = false;
  return o;
}

template <class Test>
int count(const Image& image, const Test& test) {
  return static_cast<int>(std::count_if(image.pixels.begin(), image.pixels.end(), test));
}

bool is_red(const Color& c) { return c.r > 120 && c.g < 90 && c.b < 90; }
bool is_drawn(const Color& c) { return !(c == Color{255, 255, 255}); }

// A wall in the xz plane, seen from -y.
PointLayer wall(double y = 0) {
  PointLayer layer;
  for (int i = 0; i <= 60; ++i)
    for (int j = 0; j <= 60; ++j) layer.points.push_back({i / 60.0, y, j / 60.0});
  return layer;
}

PointLayer red_point(double y) {
  PointLayer layer;
  layer.points = {{0.5, y, 0.5}};
  layer.color = kind_color(PointKind::edge);
  layer.style = PointStyle::beads;
  return layer;
}

TEST(Render, SphereCoversItsDisc) {
  Random random(1);
  PointLayer layer;
  for (int i = 0; i < 20000; ++i) layer.points.push_back(random.on_sphere());
  Scene scene;
  scene.points = {layer};
  RenderOptions o = bare(400);
  o.view.target = Vec3{}, o.view.radius = 1.5;
  const Image image = render(scene, o);
  const double size = letter_size(400, 400);  // the frame leaves 2.5 letters left and right ...
  const double height = 400 - 2 * size - heading_height(image, "", {}) - size;
  const double scale = std::min(400 - 5 * size, height) / 3;
  const double expected = pi * scale * scale;
  EXPECT_NEAR(count(image, is_drawn) / expected, 1, 0.05);
}

TEST(Render, RedPointIsSeenBeforeAWallAndNotBehindIt) {
  Scene scene;
  scene.points = {wall(), red_point(-0.2)};
  EXPECT_GT(count(render(scene, bare()), is_red), 10);
  scene.points[1] = red_point(0.2);
  EXPECT_EQ(count(render(scene, bare()), is_red), 0);
  scene.points[1] = red_point(0);  // on the wall
  EXPECT_GT(count(render(scene, bare()), is_red), 5);
}

TEST(Render, MeshHidesLinesBehindIt) {
  for (const double y : {-0.2, 0.2}) {
    Scene scene;
    MeshLayer square;
    square.points = {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}};
    square.triangles = {{0, 1, 2}, {0, 2, 3}};
    LineLayer line;
    line.lines = {{{0.2, y, 0.2}, {0.8, y, 0.8}}};
    scene.meshes = {square}, scene.lines = {line};
    EXPECT_EQ(count(render(scene, bare()), is_red) > 100, y < 0);
  }
}

TEST(Render, TrianglesCoverTheirAreaWithoutGaps) {
  Scene scene;
  MeshLayer fan;  // many slivers of one square
  fan.points = {{0.5, 0, 0.5}};
  for (int i = 0; i < 100; ++i) {
    const double a = 2 * pi * i / 100,
                 r = 0.5 / std::max(std::abs(std::cos(a)), std::abs(std::sin(a)));
    fan.points.push_back({0.5 + r * std::cos(a), 0, 0.5 + r * std::sin(a)});
  }
  for (std::uint32_t i = 0; i < 100; ++i) fan.triangles.push_back({0, 1 + i, 1 + (i + 1) % 100});
  scene.meshes = {fan};
  const Image image = render(scene, bare());
  int low_x = 1000, high_x = -1, low_y = 1000, high_y = -1;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (is_drawn(image.at(x, y)))
        low_x = std::min(low_x, x), high_x = std::max(high_x, x), low_y = std::min(low_y, y),
        high_y = std::max(high_y, y);
  const int box = (high_x - low_x + 1) * (high_y - low_y + 1);
  EXPECT_GE(count(image, is_drawn), box - 4 * (high_x - low_x));  // the corners are cut a little
}

TEST(Render, WallOfPointsHasNoHoles) {
  Scene scene;
  scene.points = {wall()};
  for (const Vec3& direction : {Vec3{0, 1, 0}, Vec3{1, 1, -0.5}}) {
    RenderOptions o = bare();
    o.view.direction = direction, o.view.target = Vec3{0.5, 0, 0.5}, o.view.radius = 0.2;
    const Image image = render(scene, o);
    int open = 0;
    for (int y = 40; y < 200; ++y)
      for (int x = 70; x < 170; ++x) open += is_drawn(image.at(x, y)) ? 0 : 1;
    EXPECT_EQ(open, 0);
  }
}

Scene busy_scene() {
  Random random(3);
  std::vector<Vec3> points;
  std::vector<PointKind> kinds;
  for (int i = 0; i < 20000; ++i) {
    points.push_back(random.on_sphere() + 0.01 * random.in_ball());
    kinds.push_back(static_cast<PointKind>(random.below(40) == 0 ? random.below(5) : 0));
  }
  Scene scene;
  add_points_by_kind(scene, points, kinds);
  MeshLayer mesh;
  mesh.wireframe = mesh.smooth = true;
  for (int i = 0; i < 300; ++i) mesh.points.push_back(1.3 * random.on_sphere());
  for (std::uint32_t i = 0; i + 2 < 300; i += 3) mesh.triangles.push_back({i, i + 1, i + 2});
  LineLayer lines;
  for (int i = 0; i < 30; ++i)
    lines.lines.push_back({random.on_sphere(), random.on_sphere(), random.on_sphere()});
  scene.meshes = {mesh}, scene.lines = {lines};
  return scene;
}

TEST(Render, SameBytesForAnyThreadCount) {
  const Scene scene = busy_scene();
  RenderOptions o;
  o.width = 320, o.height = 240;
  Job one, four;
  one.threads = 1, four.threads = 4;
  const Image a = render(scene, o, one), b = render(scene, o, four);
  EXPECT_TRUE(a.pixels == b.pixels);
}

TEST(Render, DegenerateScenesGivePictures) {
  RenderOptions o = bare(64);
  o.view.direction.reset();
  EXPECT_EQ(count(render({}, o), is_drawn), 0);
  const Vec3 nan{not_a_number, 0, 0};
  for (const std::vector<Vec3>& points :
       {std::vector<Vec3>{{1, 2, 3}}, std::vector<Vec3>(50, Vec3{1e6, 2, 3}),
        std::vector<Vec3>{{1, 2, 3}, nan, {infinity, 0, 0}},
        std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}}}) {
    Scene scene;
    scene.points.emplace_back().points = points;
    EXPECT_GT(count(render(scene, o), is_drawn), 0);
    scene.points[0].style = PointStyle::beads;
    EXPECT_GT(count(render(scene, o), is_drawn), 0);
  }
  Scene scene;
  scene.points.emplace_back().points = {nan, nan};
  scene.meshes.push_back({{nan, {0, 0, 0}, {1, 0, 0}}, {{0, 1, 2}}, {}, {}, true, true});
  EXPECT_EQ(count(render(scene, o), is_drawn), 0);
}

TEST(Render, BadScenesAndOptionsAreRefused) {
  Scene scene;
  scene.points.push_back(wall());
  RenderOptions o = bare();
  o.width = 0;
  EXPECT_THROW(render(scene, o), UsageError);
  o = bare(), o.supersampling = 9;
  EXPECT_THROW(render(scene, o), UsageError);
  scene.points[0].colors.assign(3, kind_color(PointKind::edge));
  EXPECT_THROW(render(scene, bare()), UsageError);
  Scene mesh;
  mesh.meshes.push_back({{{0, 0, 0}}, {{0, 1, 2}}, {}, {}, false, false});
  EXPECT_THROW(render(mesh, bare()), UsageError);
}

TEST(Render, StoppedJobThrowsCancelled) {
  std::stop_source source;
  source.request_stop();
  Job job;
  job.stop = source.get_token();
  Scene scene;
  scene.points.push_back(wall());
  EXPECT_THROW(render(scene, bare(), job), Cancelled);
}

TEST(Render, PanelsStandSideBySide) {
  std::vector<Panel> panels(2);
  panels[0].scene.points = {wall()};
  panels[1].scene.points = {wall()};
  panels[1].scene.points[0].color = kind_color(PointKind::edge);
  RenderOptions o = bare();
  o.width = 480;
  const Image image = render_panels(panels, o);
  int left = 0, right = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (is_red(image.at(x, y))) ++(x < 240 ? left : right);
  EXPECT_EQ(left, 0);
  EXPECT_GT(right, 10000);
}

TEST(Overlay, LegendShowsDotsAndWords) {
  Scene scene;
  scene.legend = {{"edge", kind_color(PointKind::edge), 1076}};
  RenderOptions o = bare();
  o.legend = true;
  const Image image = render(scene, o);
  EXPECT_GT(count(image, is_red), 20);
  EXPECT_GT(count(image, [](const Color& c) { return c.r < 130 && c.g < 130; }), 20);
}

TEST(Overlay, Numbers) {
  EXPECT_EQ(grouped(0), "0");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(grouped(1076), "1 076");
  EXPECT_EQ(grouped(12345678), "12 345 678");
  EXPECT_EQ(short_number(-0.0), "0");
  EXPECT_EQ(short_number(0.05), "0.05");
  EXPECT_DOUBLE_EQ(round_below(0.99), 0.5);
  EXPECT_DOUBLE_EQ(round_below(3), 2);
  EXPECT_DOUBLE_EQ(round_below(100), 100);
}

TEST(Font, EveryCharacterHasInkOfItsOwn) {
  std::vector<std::vector<Color>> seen;
  for (char c = '!'; c <= '~'; ++c) {
    Image image(40, 50);
    draw_text(image, {10, 35}, std::string(1, c), {20, ink});
    EXPECT_GT(count(image, is_drawn), 5) << c;
    for (const auto& other : seen) EXPECT_FALSE(other == image.pixels) << c;
    seen.push_back(image.pixels);
  }
}

TEST(Surfels, PlaneHasItsNormalAndSpacing) {
  const PointLayer layer = wall();
  const Surfels surfels = find_surfels(layer.points, {});
  std::size_t right = 0;
  for (std::size_t i = 0; i < layer.points.size(); ++i) {
    EXPECT_NEAR(std::abs(surfels.normals[i].y), 1, 1e-9);
    right += std::abs(static_cast<double>(surfels.spacings[i]) * 60 - 1) < 0.35 ? 1 : 0;
  }
  EXPECT_GT(right, layer.points.size() * 9 / 10);
}

TEST(Palette, MapsEndAndMiddle) {
  EXPECT_EQ(map_color(ColorMap::diverging, 0.5), (Color{246, 246, 246}));
  EXPECT_EQ(map_color(ColorMap::diverging, -3), map_color(ColorMap::diverging, 0));
  EXPECT_EQ(map_color(ColorMap::sequential, 9), map_color(ColorMap::sequential, 1));
  const auto lightness = [](const Color& c) { return 0.3 * c.r + 0.59 * c.g + 0.11 * c.b; };
  for (int i = 0; i < 50; ++i)
    EXPECT_LT(lightness(map_color(ColorMap::sequential, i / 50.0)),
              lightness(map_color(ColorMap::sequential, (i + 1) / 50.0)));
}

}  // namespace
}  // namespace spigolo
