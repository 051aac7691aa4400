// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/rivals/multi_scale_pca.cpp - multi-scale surface variation after Pauly, Keiser, Gross 2003
//
// multi_scale_pca IN.xyz OUT
// Surface variation l0 / (l0 + l1 + l2) of the covariance of n nearest neighbors, n from 12 to 96.
// Pauly counts at how many scales it exceeds a limit: "at least m scales" is the m-th largest one
// over that limit, so the columns are m-th largest variations; single scales stand beside them.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <nanoflann.hpp>

#include "points.h"

namespace {

constexpr std::size_t sizes[] = {12, 16, 24, 32, 48, 64, 96};

struct Cloud {
  std::vector<Oriented> points;
  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const { return points[i].p[axis]; }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud,
                                                 3, std::size_t>;

double variation(const Cloud& cloud, const std::vector<std::size_t>& neighbors, std::size_t n) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < n; ++i)
    mean += Eigen::Map<const Eigen::Vector3d>(cloud.points[neighbors[i]].p.data());
  mean /= double(n);
  Eigen::Matrix3d c = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < n; ++i) {
    const Eigen::Vector3d d =
        Eigen::Map<const Eigen::Vector3d>(cloud.points[neighbors[i]].p.data()) - mean;
    c += d * d.transpose();
  }
  const Eigen::Vector3d l = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(c).eigenvalues();
  return l.sum() > 0 ? std::max(0.0, l[0]) / l.sum() : 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) fail("multi_scale_pca IN.xyz OUT");
  const Cloud cloud{read_points(argv[1])};
  const Tree tree(3, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(10));
  constexpr std::size_t count = std::size(sizes), most = sizes[count - 1];
  if (cloud.points.size() <= most) fail("too few points");
  std::vector<std::vector<double>> single(count), ranked(count);
  std::vector<std::size_t> neighbors(most);
  std::vector<double> distances(most);
  for (const Oriented& o : cloud.points) {
    tree.knnSearch(o.p.data(), most, neighbors.data(), distances.data());
    std::vector<double> values;
    for (std::size_t s = 0; s < count; ++s) {
      values.push_back(variation(cloud, neighbors, sizes[s]));
      single[s].push_back(values.back());
    }
    std::sort(values.rbegin(), values.rend());
    for (std::size_t m = 0; m < count; ++m) ranked[m].push_back(values[m]);
  }
  Scores scores;
  for (std::size_t s = 0; s < count; s += 2) scores.add("k" + std::to_string(sizes[s]), single[s]);
  for (const std::size_t m : {std::size_t{0}, count / 2, count - 1})
    scores.add("at-least-" + std::to_string(m + 1) + "-scales", ranked[m]);
  write_scores(argv[2], scores);
}
