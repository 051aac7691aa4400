// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/plain_search.cpp
#include "plain_search.h"

#include <nanoflann.hpp>

#include "meter.h"
#include "spigolo/index/neighborhoods.h"

namespace spigolo::bench {
namespace {

struct Adaptor {
  const std::vector<Vec3>& points;
  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const { return points[i][axis]; }
  template <class BoundingBox>
  bool kdtree_get_bbox(BoundingBox&) const {
    return false;
  }
};

}  // namespace

double search_seconds(std::span<const Vec3> points, std::size_t k) {
  Job job;
  job.threads = 1;
  const OrderedCloud cloud = order_cloud(points, job);
  const KdTree tree(cloud);
  const double start = cpu_seconds();
  find_neighborhoods(tree, k, job);
  return cpu_seconds() - start;
}

double nanoflann_seconds(const std::vector<Vec3>& points, std::size_t k) {
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Adaptor>,
                                                   Adaptor, 3>;
  const Adaptor adaptor{points};
  Tree tree(3, adaptor, nanoflann::KDTreeSingleIndexAdaptorParams(10));
  tree.buildIndex();
  std::vector<std::size_t> index(k + 1);
  std::vector<double> squared(k + 1);
  const double start = cpu_seconds();
  for (const Vec3& p : points) {
    nanoflann::KNNResultSet<double> result(k + 1);
    result.init(index.data(), squared.data());
    tree.findNeighbors(result, &p.x, nanoflann::SearchParams());
  }
  return cpu_seconds() - start;
}

}  // namespace spigolo::bench
