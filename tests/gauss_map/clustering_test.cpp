// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
#include "spigolo/gauss_map/clustering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "spigolo/core/random.h"

namespace spigolo {
namespace {

// The text of §3.4.3 word for word: merge the closest two clusters until they are beyond sigma.
std::set<std::set<std::uint32_t>> brute_force(const GaussMap& map, double sigma) {
  std::vector<std::vector<std::uint32_t>> clusters;
  for (std::uint32_t i = 0; i < map.size; ++i) clusters.push_back({i});
  const auto linkage = [&](const auto& a, const auto& b) {  // (3.5)
    double sum = 0;
    for (const auto i : a)
      for (const auto j : b) sum += axial_angle(map.normal(i), map.normal(j));
    return sum / static_cast<double>(a.size() * b.size());
  };
  while (true) {
    double least = infinity;
    std::size_t best_a = 0, best_b = 0;
    for (std::size_t a = 0; a < clusters.size(); ++a)
      for (std::size_t b = a + 1; b < clusters.size(); ++b)
        if (const double d = linkage(clusters[a], clusters[b]); d < least)
          least = d, best_a = a, best_b = b;
    if (!(least <= sigma)) break;
    auto& into = clusters[best_a];
    into.insert(into.end(), clusters[best_b].begin(), clusters[best_b].end());
    clusters.erase(clusters.begin() + static_cast<std::ptrdiff_t>(best_b));
  }
  std::set<std::set<std::uint32_t>> result;
  for (const auto& c : clusters) result.insert({c.begin(), c.end()});
  return result;
}

std::set<std::set<std::uint32_t>> as_sets(const Clustering& c, std::size_t n) {
  std::map<std::uint32_t, std::set<std::uint32_t>> sets;
  for (std::uint32_t i = 0; i < n; ++i) sets[c.cluster[i]].insert(i);
  std::set<std::set<std::uint32_t>> result;
  for (const auto& [number, set] : sets) {
    EXPECT_EQ(c.size[number], set.size());
    result.insert(set);
  }
  return result;
}

// Triangles of a point on a noisy roof: two clusters and the mixed normals between them.
GaussMap roof(std::size_t k, double slope, double noise, Random& random) {
  std::vector<Vec3> neighbors;
  for (std::size_t i = 0; i < k; ++i) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    neighbors.push_back({x, y, -slope * std::abs(x) + noise * random.normal()});
  }
  GaussMap map;
  compute_gauss_map({0, 0, 0}, neighbors, map);
  return map;
}

TEST(Clustering, EqualsMergingTheClosestPairAgainAndAgain) {
  Random random(31);
  Clustering clustering;
  for (int trial = 0; trial < 60; ++trial) {
    const GaussMap map =
        roof(4 + random.below(7), random.uniform(0, 3), random.uniform(0.02, 0.3), random);
    for (const double sigma : {0.05, 0.1, 0.3, 0.7, 1.2}) {
      cluster_normals(map, sigma, clustering);
      ASSERT_EQ(as_sets(clustering, map.size), brute_force(map, sigma)) << trial << " " << sigma;
    }
  }
}

TEST(Clustering, OrderOfTheNormalsOnlyRelabels) {
  Random random(32);
  const GaussMap map = roof(16, 1, 0.1, random);
  GaussMap reversed = map;
  for (auto* axis : {&reversed.x, &reversed.y, &reversed.z})
    std::reverse(axis->begin(), axis->begin() + static_cast<std::ptrdiff_t>(map.size));
  Clustering a, b;
  cluster_normals(map, 0.3, a);
  cluster_normals(reversed, 0.3, b);
  const auto n = static_cast<std::uint32_t>(map.size);
  std::set<std::set<std::uint32_t>> turned;
  for (const auto& set : as_sets(b, n)) {
    std::set<std::uint32_t> s;
    for (const auto i : set) s.insert(n - 1 - i);
    turned.insert(s);
  }
  EXPECT_EQ(as_sets(a, n), turned);
}

TEST(Clustering, SignsOfTheNormalsDoNotMatter) {
  Random random(33);
  const GaussMap map = roof(12, 1, 0.05, random);
  GaussMap flipped = map;
  for (std::size_t t = 0; t < map.size; t += 2)
    flipped.x[t] = -map.x[t], flipped.y[t] = -map.y[t], flipped.z[t] = -map.z[t];
  Clustering a, b;
  cluster_normals(map, 0.2, a);
  cluster_normals(flipped, 0.2, b);
  EXPECT_EQ(a.cluster, b.cluster);
}

// Ending early must never change whether a cluster that large exists.
TEST(Clustering, DominantClusterIsFoundIfAndOnlyIfThereIsOne) {
  Random random(34);
  Clustering whole, early;
  int found = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const GaussMap map = roof(12, random.uniform(0, 0.4), random.uniform(0, 0.1), random);
    const std::size_t dominant = map.size * 7 / 10;
    cluster_normals(map, 0.3, whole);
    cluster_normals(map, 0.3, early, dominant);
    const auto largest = [](const Clustering& c) {
      return *std::max_element(c.size.begin(), c.size.end());
    };
    EXPECT_EQ(largest(whole) >= dominant, largest(early) >= dominant) << trial;
    found += largest(whole) >= dominant;
  }
  EXPECT_GT(found, 20);
  EXPECT_LT(found, 180);
}

TEST(Clustering, EmptyAndSingle) {
  Clustering clustering;
  GaussMap map;
  cluster_normals(map, 0.1, clustering);
  EXPECT_TRUE(clustering.size.empty());
  compute_gauss_map({0, 0, 0}, std::vector<Vec3>{{1, 0, 0}, {0, 1, 0}}, map);
  cluster_normals(map, 0.1, clustering);
  EXPECT_EQ(clustering.size, std::vector<std::uint32_t>{1});
}

}  // namespace
}  // namespace spigolo
