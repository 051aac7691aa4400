// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
#include "spigolo/gauss_map/connect.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "spigolo/synth/synth.h"

namespace spigolo {
namespace {

// The cube lattice with its true features, in canonical order.
struct Cube {
  SynthCloud synth;
  OrderedCloud cloud;
  std::vector<std::uint8_t> feature;

  explicit Cube(std::size_t points) {
    SynthOptions options;
    options.shape = "cube";
    options.points = points;
    synth = make_cloud(options);
    cloud = order_cloud(synth.cloud.points);
    feature.resize(cloud.size());
    const auto& truth = synth.cloud.find("truth_feature")->values;
    for (std::size_t i = 0; i < truth.size(); ++i) feature[cloud.rank[i]] = truth[i] > 0;
  }

  std::size_t edge_of(std::size_t i) const {
    return nearest_crease(synth.shape, cloud.points[i] + cloud.origin).crease;
  }
  bool at_corner(std::size_t i) const {
    return corner_distance(synth.shape, cloud.points[i] + cloud.origin) < 0.5 * synth.spacing;
  }
};

TEST(Connect, TheEdgesAtACubesCornerComeApart) {
  const Cube cube(3000);
  const KdTree tree(cube.cloud);
  const ConnectedFeatures connected = connect_features(tree, cube.feature, {});
  std::size_t kept = 0, all = 0;
  std::vector<Neighbor> found;
  for (std::uint32_t i = 0; i < cube.cloud.size(); ++i) {
    const auto list = connected.of(i);
    EXPECT_TRUE(std::is_sorted(list.begin(), list.end()));
    EXPECT_TRUE(cube.feature[i] || list.empty());
    if (!cube.feature[i] || cube.at_corner(i)) continue;
    for (const std::uint32_t j : list) {
      EXPECT_TRUE(cube.feature[j]);
      EXPECT_NE(i, j);
      EXPECT_TRUE(cube.at_corner(j) || cube.edge_of(i) == cube.edge_of(j));
    }
    tree.nearest(cube.cloud.points[i], 21, found);
    for (const Neighbor& n : found) {
      if (n.index == i || !cube.feature[n.index] || cube.at_corner(n.index)) continue;
      if (cube.edge_of(i) != cube.edge_of(n.index)) continue;
      ++all, kept += std::binary_search(list.begin(), list.end(), n.index);
    }
  }
  EXPECT_GT(kept, 0.9 * static_cast<double>(all));
}

TEST(Connect, ThreadsChangeNothing) {
  const Cube cube(2000);
  const KdTree tree(cube.cloud);
  Job one, four;
  one.threads = 1, four.threads = 4;
  const ConnectedFeatures a = connect_features(tree, cube.feature, {}, one);
  const ConnectedFeatures b = connect_features(tree, cube.feature, {}, four);
  EXPECT_EQ(a.begin, b.begin);
  EXPECT_EQ(a.features, b.features);
}

TEST(Connect, NoFeaturesNoLists) {
  const Cube cube(500);
  const std::vector<std::uint8_t> none(cube.cloud.size(), 0);
  const ConnectedFeatures connected = connect_features(KdTree(cube.cloud), none, {});
  EXPECT_TRUE(connected.features.empty());
  EXPECT_EQ(connected.begin.size(), cube.cloud.size() + 1);
}

TEST(Connect, ANeighborhoodOfFeaturesAloneConnectsNothing) {
  const Cube cube(500);
  const std::vector<std::uint8_t> all(cube.cloud.size(), 1);
  EXPECT_TRUE(connect_features(KdTree(cube.cloud), all, {}).features.empty());
}

}  // namespace
}  // namespace spigolo
