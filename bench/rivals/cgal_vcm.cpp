// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/rivals/cgal_vcm.cpp - feature edges by CGAL's Voronoi covariance measure (Merigot et al.
// 2011)
//
// cgal_vcm IN.xyz OUT SPACING
// The score is what CGAL::vcm_is_on_feature_edge compares with its threshold: the middle
// eigenvalue's share, for several offset radii R and convolution radii r in spacings.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/property_map.h>
#include <CGAL/vcm_estimate_edges.h>

#include "points.h"

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Covariance = std::array<double, 6>;

double middle_share(Covariance& c) {
  std::array<double, 3> l{};
  if (!CGAL::Default_diagonalize_traits<double, 3>::diagonalize_selfadjoint_covariance_matrix(c, l))
    return 0;
  const double sum = l[0] + l[1] + l[2];
  return sum > 0 ? l[1] / sum : 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) fail("cgal_vcm IN.xyz OUT SPACING");
  const double spacing = std::atof(argv[3]);
  std::vector<Kernel::Point_3> points;
  for (const Oriented& o : read_points(argv[1])) points.emplace_back(o.p[0], o.p[1], o.p[2]);
  Scores scores;
  for (const double R : {3.0, 6.0, 12.0}) {
    std::vector<Covariance> cells, sums;
    CGAL::compute_vcm(points, cells, R * spacing, 0.0);
    for (const double r : {0.0, 1.2, 2.0, 3.0, 4.5}) {
      if (r > 0)
        CGAL::internal::vcm_convolve(points.begin(), points.end(),
                                     CGAL::Identity_property_map<Kernel::Point_3>(), cells, sums,
                                     r * spacing, Kernel());
      else
        sums = cells;
      std::vector<double> column;
      for (Covariance& c : sums) column.push_back(middle_share(c));
      char name[32];
      std::snprintf(name, sizeof name, "R%.0f-r%.1f", R, r);
      scores.add(name, column);
    }
  }
  write_scores(argv[2], scores);
}
