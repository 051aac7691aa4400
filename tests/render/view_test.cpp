// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/render/view_test.cpp - directions and cameras against closed forms
#include <gtest/gtest.h>

#include <array>

#include "spigolo/core/error.h"
#include "spigolo/core/random.h"
#include "spigolo/render/auto_view.h"
#include "spigolo/render/camera.h"

namespace spigolo {
namespace {

void expect_near(const Vec3& a, const Vec3& b) { EXPECT_LT(distance(a, b), 1e-12); }

TEST(View, NamesLookAlongTheirAxes) {
  expect_near(*parse_view_direction("front"), {0, 1, 0});
  expect_near(*parse_view_direction("back"), {0, -1, 0});
  expect_near(*parse_view_direction("left"), {1, 0, 0});
  expect_near(*parse_view_direction("right"), {-1, 0, 0});
  expect_near(*parse_view_direction("top"), {0, 0, -1});
  expect_near(*parse_view_direction("bottom"), {0, 0, 1});
  expect_near(*parse_view_direction("iso"), normalized({-1, 1, -1}));
  expect_near(*parse_view_direction("90,0"), {-1, 0, 0});
  EXPECT_FALSE(parse_view_direction("auto"));
}

TEST(View, OtherTextIsRefused) {
  for (const char* text : {"", "fron", "10", "10,", ",5", "1,2,3", "0,91", "nan,0", "1e999,0"})
    EXPECT_THROW(parse_view_direction(text), UsageError) << text;
}

std::vector<Vec3> cube_corners(const Vec3& middle) {
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back(middle + Vec3{double(i & 1), double(i >> 1 & 1), double(i >> 2 & 1)});
  return corners;
}

TEST(Camera, FitsEveryPointIntoTheFrameAndTouchesIt) {
  for (const bool perspective : {true, false})
    for (const Vec3& direction : {Vec3{1, 2, -1}, Vec3{0, 0, -1}, Vec3{-1, 0, 0}}) {
      const std::vector<Vec3> corners = cube_corners({500000, 4000000, 100});
      const std::array<std::span<const Vec3>, 1> all = {corners};
      View view;
      view.perspective = perspective;
      const Frame frame{10, 20, 210, 320};
      const Camera camera = fit_camera(all, view, direction, frame);
      Box seen;
      for (const Vec3& p : corners) {
        const Projected q = camera.project(p);
        seen.add({q.x, q.y, 0});
        EXPECT_GT(q.z, 0);
        const Vec3 back = camera.unproject(q.x, q.y, q.z);
        const Vec3 d = p - camera.center;
        EXPECT_NEAR(back.x, dot(d, camera.right), 1e-6);
        EXPECT_NEAR(back.y, dot(d, camera.up), 1e-6);
      }
      EXPECT_NEAR(seen.center().x, 110, 1e-6);
      EXPECT_NEAR(seen.center().y, 170, 1e-6);
      const double slack = std::min(200 - seen.size().x, 300 - seen.size().y);
      EXPECT_NEAR(slack, 0, 1e-6);
    }
}

TEST(Camera, TargetIsInTheMiddleAndItsRadiusFits) {
  const std::vector<Vec3> corners = cube_corners({});
  const std::array<std::span<const Vec3>, 1> all = {corners};
  View view;
  view.perspective = false, view.target = Vec3{1, 0, 1}, view.radius = 0.1;
  const Camera camera = fit_camera(all, view, {0, 1, 0}, {0, 0, 400, 200});
  EXPECT_NEAR(camera.project({1, 0, 1}).x, 200, 1e-9);
  EXPECT_NEAR(camera.project({1, 0, 1}).y, 100, 1e-9);
  EXPECT_NEAR(camera.project({1.1, 0, 1}).x, 300, 1e-9);
  EXPECT_NEAR(camera.project({1, 0, 1.1}).y, 0, 1e-9);
}

TEST(AutoView, LooksIntoAnOpenBox) {
  // Five inner walls; the open side points along -x, features before the far wall.
  Scene scene;
  PointLayer walls, marks;
  marks.style = PointStyle::beads;
  Random random(1);
  for (int i = 0; i < 20000; ++i) {
    const double u = random.uniform(), v = random.uniform();
    const std::array<Vec3, 5> wall = {{{1, u, v}, {u, 0, v}, {u, 1, v}, {u, v, 0}, {u, v, 1}}};
    walls.points.push_back(wall[random.below(5)]);
    marks.points.push_back({0.8, 0.25 + 0.5 * u, 0.25 + 0.5 * v});
  }
  scene.points = {walls, marks};
  EXPECT_GT(best_direction(scene, {}).x, 0.3);
}

}  // namespace
}  // namespace spigolo
