// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/gauss_map/connect.cpp - Gauss map of the triangles of two feature points and one other
#include "spigolo/gauss_map/connect.h"

#include <algorithm>
#include <cmath>

#include "spigolo/core/parallel.h"
#include "spigolo/gauss_map/clustering.h"
#include "spigolo/gauss_map/edges.h"

namespace spigolo {
namespace {

constexpr std::size_t grain = 64;
constexpr std::size_t least_triangles = 3;

// The pair test and the memory it works in.
class PairTest {
 public:
  PairTest(std::span<const Vec3> points, const ConnectOptions& options)
      : points_(points), options_(options) {}

  // others: the points of f1's neighborhood that are no features.
  bool connected(const Vec3& f1, const Vec3& f2, std::span<const std::uint32_t> others) {
    fill_map(f1, f2, others);
    if (map_.size < least_triangles) return false;
    cluster_normals(map_, options_.sigma, clustering_);
    const double smallest = std::max(2.0, options_.min_cluster * static_cast<double>(map_.size));
    std::size_t clusters = 0, inside = 0;
    for (const std::uint32_t size : clustering_.size) {
      if (size < smallest) continue;
      ++clusters, inside += size;
    }
    // Normals in no cluster worth the name are what a second edge looks like, too.
    const bool clear = static_cast<double>(map_.size - inside) < smallest;
    return clear && (clusters == 1 || clusters == 2);
  }

 private:
  void fill_map(const Vec3& f1, const Vec3& f2, std::span<const std::uint32_t> others) {
    const std::size_t wanted = std::min(others.size(), options_.triangles);
    for (std::vector<float>* axis : {&map_.x, &map_.y, &map_.z})
      axis->assign(wanted + Edges::widest_vector, 0.0f);
    map_.size = 0;
    const Vec3 along = normalized(f2 - f1);
    for (std::size_t i = 0; i < wanted; ++i) {  // evenly over the neighborhood
      const Vec3& other = points_[others[i * others.size() / wanted]];
      const Vec3 n = cross(along, normalized(other - f1));
      const double sine = norm(n);
      if (sine < degenerate_sine) continue;
      map_.x[map_.size] = static_cast<float>(n.x / sine);
      map_.y[map_.size] = static_cast<float>(n.y / sine);
      map_.z[map_.size++] = static_cast<float>(n.z / sine);
    }
  }

  std::span<const Vec3> points_;
  const ConnectOptions& options_;
  GaussMap map_;
  Clustering clustering_;
};

// The lists of the feature points [begin, end) of `features`, one behind the other.
void connect_range(const KdTree& tree, std::span<const std::uint8_t> is_feature,
                   std::span<const std::uint32_t> features, const ConnectOptions& options,
                   std::vector<std::uint32_t>* lists) {
  const std::span<const Vec3> points = tree.points();
  PairTest test(points, options);
  std::vector<Neighbor> found;
  std::vector<std::uint32_t> others;
  for (std::size_t f = 0; f < features.size(); ++f) {
    const std::uint32_t f1 = features[f];
    tree.nearest(points[f1], options.k + 1, found);
    others.clear();
    for (const Neighbor& n : found)
      if (!is_feature[n.index]) others.push_back(n.index);
    for (const Neighbor& n : found)
      if (is_feature[n.index] && n.index != f1 &&
          test.connected(points[f1], points[n.index], others))
        lists[f].push_back(n.index);
    std::sort(lists[f].begin(), lists[f].end());
  }
}

}  // namespace

ConnectedFeatures connect_features(const KdTree& tree, std::span<const std::uint8_t> is_feature,
                                   const ConnectOptions& options, const Job& job) {
  std::vector<std::uint32_t> features;
  for (std::uint32_t i = 0; i < is_feature.size(); ++i)
    if (is_feature[i]) features.push_back(i);
  std::vector<std::vector<std::uint32_t>> lists(features.size());
  parallel_for(job, "connected features", features.size(), grain,
               [&](std::size_t begin, std::size_t end) {
                 connect_range(tree, is_feature, std::span(features).subspan(begin, end - begin),
                               options, lists.data() + begin);
               });
  ConnectedFeatures result;
  result.begin.assign(is_feature.size() + 1, 0);
  for (std::size_t i = 0, f = 0; i < is_feature.size(); ++i) {
    if (is_feature[i]) {
      const auto& list = lists[f++];
      result.features.insert(result.features.end(), list.begin(), list.end());
    }
    result.begin[i + 1] = static_cast<std::uint32_t>(result.features.size());
  }
  return result;
}

}  // namespace spigolo
