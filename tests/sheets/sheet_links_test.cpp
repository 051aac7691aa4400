// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/sheets/sheet_links_test.cpp - joined block by block, and at a glance, as one by one
#include "spigolo/sheets/sheet_links.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "spigolo/index/prepared_cloud.h"
#include "spigolo/sheets/local_noise.h"
#include "spigolo/sheets/own_sheet.h"
#include "spigolo/synth/synth.h"

namespace spigolo {
namespace {

struct Looked {
  PreparedCloud prepared;
  std::vector<Sheet> sheets;
  SheetCloud cloud() const {
    return {prepared.cloud.points, prepared.neighborhoods, prepared.spacing, sheets};
  }
};

Looked look_at(const std::vector<Vec3>& points) {
  Looked looked{prepare_cloud(points, 20), {}};
  const PreparedCloud& p = looked.prepared;
  looked.sheets =
      find_own_sheets(p.cloud.points, p.neighborhoods, p.spacing, sheet_tolerances(p.noise));
  return looked;
}

Looked look(const std::string& shape, double noise, std::size_t points = 4000) {
  SynthOptions options;
  options.shape = shape;
  options.sampling = Sampling::random;
  options.points = points;
  options.noise = noise;
  options.seed = 5;
  return look_at(make_cloud(options).cloud.points);
}

// A band with half a twist: no choice of sides is right all the way round.
std::vector<Vec3> moebius_band(int around, int across) {
  std::vector<Vec3> points;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double turn = 2 * pi * i / around, out = 0.25 * (2.0 * j / (across - 1) - 1);
      const double radius = 1 + out * std::cos(turn / 2);
      points.push_back(
          {radius * std::cos(turn), radius * std::sin(turn), out * std::sin(turn / 2)});
    }
  return points;
}

struct Link {
  std::uint32_t a, b;
  bool differ;
};

ParitySets joined_one_by_one(const SheetCloud& cloud, const std::vector<Vec3>& normal,
                             double near) {
  std::vector<Link> links[3];
  for (std::uint32_t i = 0; i < cloud.size(); ++i) {
    for (const std::uint32_t j : cloud.neighborhoods.of(i).first(8)) {
      const double cosine = dot(normal[i], normal[j]), size = std::abs(cosine);
      if (size >= 0.9 && std::abs(height(cloud.sheets[i], cloud.points[j])) <= near &&
          std::abs(height(cloud.sheets[j], cloud.points[i])) <= near)
        links[size > 0.999 ? 0 : size > 0.98 ? 1 : 2].push_back({i, j, cosine < 0});
    }
  }
  ParitySets sets(cloud.size());
  for (const auto& level : links)
    for (const Link& link : level) sets.join(link.a, link.b, link.differ);
  return sets;
}

std::size_t linked_otherwise(const Looked& looked) {
  const std::vector<Vec3> normal = own_normals(looked.cloud());
  ParitySets expected = joined_one_by_one(looked.cloud(), normal, 0.35);
  ParitySets sets = link_along_sheets(looked.cloud(), normal, 0.35);
  sets.flatten();
  std::size_t different = 0;
  for (std::uint32_t i = 0; i < normal.size(); ++i) {
    const auto a = sets.root(i), b = expected.find(i);
    different += a.set != b.set || a.parity != b.parity;
  }
  return different;
}

constexpr std::size_t two_blocks = 34000;  // points; those of one block are joined by one thread

TEST(SheetLinks, SameAsOneByOne) {
  for (const char* shape : {"box", "torus", "plate", "cylinders"})
    for (const double noise : {0.0, 0.2})
      EXPECT_EQ(linked_otherwise(look(shape, noise, 2000)), 0u) << shape << " " << noise;
  EXPECT_EQ(linked_otherwise(look("cylinders", 0, two_blocks)), 0u);
  EXPECT_EQ(linked_otherwise(look("box", 0.05, two_blocks)), 0u);
}

// The blocks' sides cannot all agree, so the links are gone through in their order.
TEST(SheetLinks, SameAsOneByOneWhereTheyContradict) {
  EXPECT_EQ(linked_otherwise(look_at(moebius_band(850, 40))), 0u);
}

TEST(LocalNoise, QuietMeansOneLevel) {
  for (const char* shape : {"box", "torus", "star", "cone"}) {
    for (const double noise : {0.0, 0.01, 0.05, 0.3}) {
      const Looked looked = look(shape, noise);
      if (!is_quiet(looked.cloud())) continue;
      const auto levels = noise_levels(estimate_local_noise(looked.cloud()), 0.5);
      EXPECT_EQ(levels, std::vector<double>(1, 0.5)) << shape << " " << noise;
    }
  }
  EXPECT_TRUE(is_quiet(look("torus", 0).cloud()));
  EXPECT_FALSE(is_quiet(look("torus", 0.3).cloud()));
}

}  // namespace
}  // namespace spigolo
