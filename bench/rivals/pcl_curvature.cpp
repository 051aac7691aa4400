// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/rivals/pcl_curvature.cpp - PCL's NormalEstimation: its curvature as a score, for several k
//
// pcl_curvature IN.xyz OUT
#include <pcl/features/normal_3d.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>

#include "points.h"

int main(int argc, char** argv) {
  if (argc != 3) fail("pcl_curvature IN.xyz OUT");
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud(new pcl::PointCloud<pcl::PointXYZ>);
  for (const Oriented& o : read_points(argv[1]))
    cloud->push_back(pcl::PointXYZ(float(o.p[0]), float(o.p[1]), float(o.p[2])));
  pcl::search::KdTree<pcl::PointXYZ>::Ptr tree(new pcl::search::KdTree<pcl::PointXYZ>);
  Scores scores;
  for (const int k : {8, 12, 16, 24, 32, 48}) {
    pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
    estimation.setInputCloud(cloud);
    estimation.setSearchMethod(tree);
    estimation.setKSearch(k);
    pcl::PointCloud<pcl::Normal> normals;
    estimation.compute(normals);
    std::vector<double> column;
    for (const pcl::Normal& n : normals) column.push_back(n.curvature);
    scores.add("k" + std::to_string(k), column);
  }
  write_scores(argv[2], scores);
}
