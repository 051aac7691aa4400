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

Looked look(const std::string& shape, double noise, std::size_t points = 4000) {
  SynthOptions options;
  options.shape = shape;
  options.sampling = Sampling::random;
  options.points = points;
  options.noise = noise;
  options.seed = 5;
  Looked looked{prepare_cloud(make_cloud(options).cloud.points, 20), {}};
  const PreparedCloud& p = looked.prepared;
  looked.sheets =
      find_own_sheets(p.cloud.points, p.neighborhoods, p.spacing, sheet_tolerances(p.noise));
  return looked;
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

TEST(SheetLinks, SameAsOneByOne) {
  for (const char* shape : {"box", "torus", "plate", "cylinders"}) {
    for (const double noise : {0.0, 0.2}) {
      const Looked looked = look(shape, noise, 40000);
      const std::vector<Vec3> normal = own_normals(looked.cloud());
      ParitySets expected = joined_one_by_one(looked.cloud(), normal, 0.35);
      ParitySets sets = link_along_sheets(looked.cloud(), normal, 0.35);
      sets.flatten();
      std::size_t different = 0;
      for (std::uint32_t i = 0; i < normal.size(); ++i) {
        const auto a = sets.root(i), b = expected.find(i);
        different += a.set != b.set || a.parity != b.parity;
      }
      EXPECT_EQ(different, 0u) << shape << " " << noise;
    }
  }
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
