// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/rivals/cgal_points.cpp - CGAL's point set processing: oriented normals, bilateral
// smoothing, edge-aware upsampling
//
// cgal_points normals IN.xyz OUT.xyz K
// cgal_points bilateral IN.xyz OUT.xyz K SHARPNESS_DEGREES ITERATIONS
// cgal_points upsample IN.xyz OUT.xyz SHARPNESS_DEGREES RADIUS COUNT
// IN has normals but for the first.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/bilateral_smooth_point_set.h>
#include <CGAL/edge_aware_upsample_point_set.h>
#include <CGAL/mst_orient_normals.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>

#include "points.h"

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Pair = std::pair<Kernel::Point_3, Kernel::Vector_3>;
using Pairs = std::vector<Pair>;
using Tag = CGAL::Sequential_tag;

auto maps() {
  return CGAL::parameters::point_map(CGAL::First_of_pair_property_map<Pair>())
      .normal_map(CGAL::Second_of_pair_property_map<Pair>());
}

Pairs load(const char* path) {
  Pairs pairs;
  for (const Oriented& o : read_points(path))
    pairs.emplace_back(Kernel::Point_3(o.p[0], o.p[1], o.p[2]),
                       Kernel::Vector_3(o.n[0], o.n[1], o.n[2]));
  return pairs;
}

void save(const char* path, const Pairs& pairs) {
  std::vector<Oriented> points;
  for (const Pair& q : pairs)
    points.push_back(
        {{q.first.x(), q.first.y(), q.first.z()}, {q.second.x(), q.second.y(), q.second.z()}});
  write_points(path, points);
}

/// Orientation moves the points it cannot reach to the end; an index in the map keeps the order.
void normals(const char* in, const char* out, int k) {
  using Row = std::tuple<Kernel::Point_3, Kernel::Vector_3, std::size_t>;
  std::vector<Row> rows;
  const Pairs pairs = load(in);
  for (std::size_t i = 0; i < pairs.size(); ++i)
    rows.emplace_back(pairs[i].first, pairs[i].second, i);
  const auto np = CGAL::parameters::point_map(CGAL::Nth_of_tuple_property_map<0, Row>())
                      .normal_map(CGAL::Nth_of_tuple_property_map<1, Row>());
  CGAL::pca_estimate_normals<Tag>(rows, unsigned(k), np);
  CGAL::mst_orient_normals(rows, unsigned(k), np);
  Pairs ordered(pairs.size());
  for (const Row& row : rows) ordered[std::get<2>(row)] = {std::get<0>(row), std::get<1>(row)};
  save(out, ordered);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string mode = argc > 1 ? argv[1] : "";
  if (mode == "normals" && argc == 5) {
    normals(argv[2], argv[3], std::atoi(argv[4]));
  } else if (mode == "bilateral" && argc == 7) {
    Pairs pairs = load(argv[2]);
    for (int i = 0; i < std::atoi(argv[6]); ++i)
      CGAL::bilateral_smooth_point_set<Tag>(pairs, unsigned(std::atoi(argv[4])),
                                            maps().sharpness_angle(std::atof(argv[5])));
    save(argv[3], pairs);
  } else if (mode == "upsample" && argc == 7) {
    const Pairs pairs = load(argv[2]);
    Pairs more = pairs;
    CGAL::edge_aware_upsample_point_set<Tag>(
        pairs, std::back_inserter(more),
        maps()
            .sharpness_angle(std::atof(argv[4]))
            .edge_sensitivity(0.5)
            .neighbor_radius(std::atof(argv[5]))
            .number_of_output_points(std::size_t(std::atol(argv[6]))));
    save(argv[3], more);
  } else {
    fail("cgal_points normals|bilateral|upsample IN.xyz OUT.xyz ...");
  }
}
