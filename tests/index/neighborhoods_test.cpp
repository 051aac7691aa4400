// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "spigolo/index/group_search.h"
#include "spigolo/index/kd_tree.h"
#include "spigolo/index/neighborhoods.h"
#include "spigolo/index/row_search.h"
#include "support/clouds.h"

namespace spigolo {
namespace {

using test::hard_clouds;

std::vector<std::uint32_t> brute_force(std::span<const Vec3> points, std::uint32_t i,
                                       std::size_t k) {
  std::vector<Neighbor> all;
  for (std::uint32_t j = 0; j < points.size(); ++j)
    if (j != i) all.push_back({squared_distance(points[i], points[j]), j});
  std::sort(all.begin(), all.end());
  std::vector<std::uint32_t> nearest;
  for (std::size_t n = 0; n < std::min(k, all.size()); ++n) nearest.push_back(all[n].index);
  return nearest;
}

TEST(Order, DependsOnTheSetOfPointsAlone) {
  for (const auto& [name, points] : hard_clouds()) {
    const OrderedCloud a = order_cloud(points), b = order_cloud(test::shuffled(points, 9));
    validate(a);
    validate(b);
    EXPECT_EQ(a.points, b.points) << name;
    EXPECT_EQ(a.duplicates, b.duplicates) << name;
    for (std::size_t i = 0; i < points.size(); ++i)
      ASSERT_EQ(a.points[a.rank[i]], points[i] - a.origin) << name;
  }
}

TEST(Order, CountsRepeatedPlacesAndLeavesOutWhatIsNotFinite) {
  std::vector<Vec3> points = test::repeated(test::square_lattice(10));
  const std::size_t repeats = points.size() - 100;
  points.push_back({not_a_number, 0, 0});
  points.push_back({0, infinity, 0});
  const OrderedCloud cloud = order_cloud(points);
  validate(cloud);
  EXPECT_EQ(cloud.size(), 100u);
  EXPECT_EQ(cloud.duplicates, repeats);
  EXPECT_EQ(cloud.non_finite, 2u);
  EXPECT_EQ(cloud.rank[points.size() - 1], no_point);
}

// Powers of two and lattice offsets are exact: the same curve must come out.
TEST(Order, ShiftAndScaleChangeNothing) {
  const auto points = test::random_sphere(3000, 11);
  const OrderedCloud a = order_cloud(points);
  std::vector<Vec3> scaled = points;
  for (Vec3& p : scaled) p *= 1024.0;
  EXPECT_EQ(order_cloud(scaled).rank, a.rank);
  EXPECT_EQ(order_cloud(test::moved(test::square_lattice(41), {1 << 20, -4096, 512})).rank,
            order_cloud(test::square_lattice(41)).rank);
}

TEST(KdTree, NearestAndWithinAgreeWithBruteForce) {
  Random random(12);
  std::vector<Neighbor> found;
  for (const auto& [name, points] : hard_clouds()) {
    const OrderedCloud cloud = order_cloud(points);
    const KdTree tree(cloud);
    for (int q = 0; q < 40; ++q) {
      const Vec3 query = cloud.points[random.below(cloud.size())] * random.uniform(0.5, 1.5);
      std::vector<Neighbor> all;
      for (std::uint32_t j = 0; j < cloud.size(); ++j)
        all.push_back({squared_distance(cloud.points[j], query), j});
      std::sort(all.begin(), all.end());
      const std::size_t k = std::min<std::size_t>(1 + random.below(30), all.size());
      tree.nearest(query, k, found);
      ASSERT_EQ(found.size(), k) << name;
      for (std::size_t i = 0; i < k; ++i) ASSERT_EQ(found[i].index, all[i].index) << name;
      const double radius = std::sqrt(all[k - 1].squared_distance) * 1.0001;
      tree.within(query, radius, found);
      const auto inside = std::count_if(all.begin(), all.end(), [&](const Neighbor& n) {
        return n.squared_distance <= radius * radius;
      });
      EXPECT_EQ(found.size(), static_cast<std::size_t>(inside)) << name;
    }
  }
}

TEST(Neighborhoods, AgreeWithBruteForceToTheLastTie) {
  for (const auto& [name, points] : hard_clouds()) {
    const OrderedCloud cloud = order_cloud(points);
    const KdTree tree(cloud);
    for (const std::size_t k : {1u, 8u, 16u, 20u, 40u}) {
      SCOPED_TRACE(name + ", k = " + std::to_string(k));
      const Neighborhoods all = find_neighborhoods(tree, k);
      ASSERT_NO_THROW(validate(all, cloud.points));
      ASSERT_EQ(all.k, std::min(k, cloud.size() - 1)) << name;
      for (std::uint32_t i = 0; i < cloud.size() && all.k > 0; i += 3) {
        const auto row = all.of(i);
        ASSERT_EQ(std::vector<std::uint32_t>(row.begin(), row.end()),
                  brute_force(cloud.points, i, k))
            << name << " point " << i << " k " << k;
      }
    }
  }
}

TEST(Neighborhoods, SameForAnyNumberOfThreads) {
  const OrderedCloud cloud = order_cloud(test::random_sphere(20000, 13));
  const KdTree tree(cloud);
  Job one;
  one.threads = 1;
  const auto reference = find_neighborhoods(tree, 20, one).index;
  for (const int threads : {2, 3, 8}) {
    Job job;
    job.threads = threads;
    EXPECT_EQ(find_neighborhoods(tree, 20, job).index, reference) << threads;
  }
}

TEST(GroupSearch, RankIsAStableSort) {
  Random random(14);
  for (std::size_t n = 1; n < 70; ++n) {
    std::vector<double> distance(n);
    for (double& d : distance) d = static_cast<double>(random.below(9));
    std::vector<std::uint32_t> expected(n), ranked(n);
    for (std::uint32_t i = 0; i < n; ++i) expected[i] = i;
    std::stable_sort(expected.begin(), expected.end(),
                     [&](auto a, auto b) { return distance[a] < distance[b]; });
    rank_ascending(distance.data(), n, n, ranked.data());
    ASSERT_EQ(ranked, expected) << n;
  }
}

// Points that lie together and such that do not, a different number of them each time.
TEST(RowSearch, FindsWhatOneSearchAPointFinds) {
  for (const auto& [name, points] : hard_clouds()) {
    const OrderedCloud cloud = order_cloud(points);
    const auto n = static_cast<std::uint32_t>(cloud.size());
    const std::size_t k = std::min<std::size_t>(40, n - 1);
    const KdTree tree(cloud);
    RowSearch search(tree, k);
    for (std::uint32_t first = 0, step = 1; first < n; first += 97, step = step % 60 + 7) {
      std::vector<std::uint32_t> queries;
      for (std::uint32_t q = first; q < n && queries.size() < 5; q += step) queries.push_back(q);
      std::vector<std::uint32_t> rows(queries.size() * k);
      search.find(queries, rows.data());
      for (std::size_t q = 0; q < queries.size(); ++q) {
        const auto row = rows.begin() + static_cast<std::ptrdiff_t>(q * k);
        ASSERT_EQ(std::vector<std::uint32_t>(row, row + static_cast<std::ptrdiff_t>(k)),
                  brute_force(cloud.points, queries[q], k))
            << name << " " << queries[q];
      }
    }
  }
}

}  // namespace
}  // namespace spigolo
