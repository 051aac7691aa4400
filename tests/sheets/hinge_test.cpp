// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
#include "spigolo/sheets/hinge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "spigolo/core/random.h"

namespace spigolo {
namespace {

// Points of z = height(x, y) in a disc of unit density around (x0, 0), shaken along every axis and
// turned out of the axes. The one above the middle comes first.
struct Scene {
  std::vector<Vec3> points;
  Vec3 x, y, z;
  Vec3 local(const Vec3& p) const { return {dot(p, x), dot(p, y), dot(p, z)}; }
};

Scene scene(const std::function<double(double)>& height, double x0, int count, double noise,
            Random& random) {
  Scene s;
  s.z = random.on_sphere();
  s.x = any_perpendicular(s.z);
  s.y = cross(s.z, s.x);
  const double radius = std::sqrt(count / pi);
  const auto add = [&](double x, double y) {
    const Vec3 p =
        Vec3{x, y, height(x)} + noise * Vec3{random.normal(), random.normal(), random.normal()};
    s.points.push_back(s.x * p.x + s.y * p.y + s.z * p.z);
  };
  add(x0, 0);
  while (static_cast<int>(s.points.size()) < count) {
    const double x = random.uniform(-radius, radius), y = random.uniform(-radius, radius);
    if (x * x + y * y < radius * radius) add(x0 + x, y);
  }
  return s;
}

int folds(const std::function<double(double)>& height, int count, double noise, Fold kind) {
  Random random(93);
  HingeTest test(noise);
  int n = 0;
  for (int trial = 0; trial < 200; ++trial)
    n += test.find(scene(height, random.uniform(-1, 1), count, noise, random).points, 1).fold ==
         kind;
  return n;
}

double flat(double) { return 0; }
double bowl(double x) { return x * x / 40; }
double roof(double x) { return -0.577 * std::abs(x); }  // 60 degrees from flat

TEST(Hinge, SmoothSheetsHaveNone) {
  for (const double noise : {0.1, 0.4, 0.8}) {
    EXPECT_EQ(folds(flat, 96, noise, Fold::none), 200) << noise;
    EXPECT_EQ(folds(bowl, 96, noise, Fold::none), 200) << noise;
  }
}

// The wider the neighborhood, the more noise a fold stands out of.
TEST(Hinge, WiderNeighborhoodsSeeThroughMoreNoise) {
  EXPECT_GE(folds(roof, 48, 0.1, Fold::edge), 190);
  EXPECT_LE(folds(roof, 48, 0.8, Fold::edge), 10);
  EXPECT_GE(folds(roof, 192, 0.4, Fold::edge), 180);
  EXPECT_GE(folds(roof, 384, 0.8, Fold::edge), 165);
}

// A quadric follows most of a rounded fold: with noise only a part of them is told from sharp ones.
TEST(Hinge, RoundedFoldsAreBends) {
  const auto fillet = [](double x) { return -0.8 * std::sqrt(x * x + 9); };
  const auto sharp = [](double x) { return -0.8 * std::abs(x); };
  EXPECT_GE(folds(fillet, 192, 0.1, Fold::bend), 190);
  EXPECT_GE(folds(fillet, 192, 0.3, Fold::bend), 110);
  EXPECT_LE(folds(sharp, 192, 0.3, Fold::bend), 20);
}

TEST(Hinge, PlaceDirectionAndAngleAreThoseOfTheFold) {
  Random random(94);
  HingeTest test(0.3);
  std::vector<double> off, turned, angle;
  for (int trial = 0; trial < 100; ++trial) {
    const Scene s = scene(roof, random.uniform(-1, 1), 192, 0.3, random);
    const Hinge hinge = test.find(s.points, 1);
    if (hinge.fold != Fold::edge) continue;
    const Vec3 p = s.local(hinge.point), d = s.local(hinge.direction);
    off.push_back(std::hypot(p.x, p.z));
    turned.push_back(std::acos(std::min(1.0, std::abs(d.y))));
    angle.push_back(std::abs(hinge.deviation - 2 * std::atan(0.577)));
    for (const Vec3& into : hinge.into) EXPECT_LT(s.local(into).z, 0);
    EXPECT_NEAR(dot(hinge.into[0], hinge.direction), 0, 1e-12);
  }
  ASSERT_GE(off.size(), 90u);
  const auto median = [](std::vector<double> v) {
    std::nth_element(v.begin(), v.begin() + static_cast<std::ptrdiff_t>(v.size() / 2), v.end());
    return v[v.size() / 2];
  };
  EXPECT_LT(median(off), 0.15);  // half a standard deviation
  EXPECT_LT(median(turned), radians(3));
  EXPECT_LT(median(angle), radians(5));
}

// Two walls are no fold, and too few points are nothing.
TEST(Hinge, WhatIsNoHeightFieldIsUnclear) {
  Random random(95);
  Scene s = scene(flat, 0, 96, 0.1, random);
  for (std::size_t i = 1; i < s.points.size(); i += 2) s.points[i] += s.z * 2.5;
  EXPECT_EQ(HingeTest(0.1).find(s.points, 1).fold, Fold::unclear);
  EXPECT_EQ(HingeTest(0.1).find(std::span(s.points).first(10), 1).fold, Fold::none);
}

TEST(Hinge, ScalesWithTheCloud) {
  Random random(96);
  Scene s = scene(roof, 0.5, 192, 0.3, random);
  HingeTest test(0.3);
  const Hinge one = test.find(s.points, 1);
  for (Vec3& p : s.points) p *= 1e-3;
  const Hinge small = test.find(s.points, 1e-3);
  EXPECT_EQ(small.fold, one.fold);
  EXPECT_LT(distance(small.point, one.point * 1e-3), 1e-9);
}

}  // namespace
}  // namespace spigolo
