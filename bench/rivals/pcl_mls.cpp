// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/rivals/pcl_mls.cpp - PCL's MovingLeastSquares: projects one cloud onto the surface of
// another
//
// pcl_mls CLOUD.xyz QUERIES.xyz OUT.xyz RADIUS
// Polynomial of order 2. Every query gives one row: its projection and normal; the query itself
// with a zero normal where PCL finds no surface.
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>
#include <pcl/surface/mls.h>
#include <pcl/surface/impl/mls.hpp>

#include "points.h"

int main(int argc, char** argv) {
  if (argc != 5) fail("pcl_mls CLOUD.xyz QUERIES.xyz OUT.xyz RADIUS");
  const double radius = std::atof(argv[4]);
  auto load = [](const char* path) {
    pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
    for (const Oriented& o : read_points(path))
      cloud->push_back(pcl::PointXYZ(float(o.p[0]), float(o.p[1]), float(o.p[2])));
    return cloud;
  };
  const auto cloud = load(argv[1]), queries = load(argv[2]);
  pcl::search::KdTree<pcl::PointXYZ>::Ptr tree(new pcl::search::KdTree<pcl::PointXYZ>);
  tree->setInputCloud(cloud);
  std::vector<Oriented> out;
  pcl::MLSResult mls;
  for (const pcl::PointXYZ& q : *queries) {
    Oriented o;
    o.p = {q.x, q.y, q.z};
    pcl::Indices indices;
    std::vector<float> distances;
    if (tree->radiusSearch(q, radius, indices, distances) >= 3) {
      // as MovingLeastSquares does for each point, with the query in place of a point of the cloud
      pcl::PointCloud<pcl::PointXYZ> local(*cloud, indices);
      local.push_back(q);
      pcl::Indices own(local.size() - 1);
      for (std::size_t i = 0; i < own.size(); ++i) own[i] = int(i);
      mls.computeMLSSurface<pcl::PointXYZ>(local, int(local.size()) - 1, own, radius, 2);
      const auto p = mls.projectQueryPoint(pcl::MLSResult::SIMPLE, 6);
      o.p = {p.point[0], p.point[1], p.point[2]};
      o.n = {p.normal[0], p.normal[1], p.normal[2]};
    }
    out.push_back(o);
  }
  write_points(argv[3], out);
}
