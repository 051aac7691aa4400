// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// bench/rivals/cgal_mesh.cpp - CGAL's meshes: advancing front, Poisson
//
// cgal_mesh advancing-front IN.xyz OUT.off
// cgal_mesh poisson IN.xyz OUT.off SPACING RADIUS DISTANCE      (IN has oriented normals)
// RADIUS and DISTANCE of the surface mesher, in spacings; CGAL's defaults are 30 and 0.375.
#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh/IO/OFF.h>
#include <CGAL/poisson_surface_reconstruction.h>
#include <CGAL/property_map.h>

#include "points.h"

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Pair = std::pair<Kernel::Point_3, Kernel::Vector_3>;
using Facet = std::array<std::size_t, 3>;

void advancing_front(const char* in, const char* path) {
  std::vector<Kernel::Point_3> points;
  for (const Oriented& o : read_points(in)) points.emplace_back(o.p[0], o.p[1], o.p[2]);
  std::vector<Facet> facets;
  CGAL::advancing_front_surface_reconstruction(points.begin(), points.end(),
                                               std::back_inserter(facets));
  std::ofstream out(path);
  out.precision(17);
  out << "OFF\n" << points.size() << " " << facets.size() << " 0\n";
  for (const auto& p : points) out << p << "\n";
  for (const Facet& f : facets) out << "3 " << f[0] << " " << f[1] << " " << f[2] << "\n";
}

void poisson(const char* in, const char* path, const std::array<double, 3>& size) {
  std::vector<Pair> pairs;
  for (const Oriented& o : read_points(in))
    pairs.emplace_back(Kernel::Point_3(o.p[0], o.p[1], o.p[2]),
                       Kernel::Vector_3(o.n[0], o.n[1], o.n[2]));
  Mesh mesh;
  if (!CGAL::poisson_surface_reconstruction_delaunay(
          pairs.begin(), pairs.end(), CGAL::First_of_pair_property_map<Pair>(),
          CGAL::Second_of_pair_property_map<Pair>(), mesh, size[0], 20.0, size[1], size[2]))
    fail("no Poisson surface");
  std::ofstream out(path);
  out.precision(17);
  CGAL::IO::write_OFF(out, mesh);
}

}  // namespace

int main(int argc, char** argv) {
  const std::string mode = argc > 1 ? argv[1] : "";
  if (mode == "advancing-front" && argc == 4)
    advancing_front(argv[2], argv[3]);
  else if (mode == "poisson" && argc == 7)
    poisson(argv[2], argv[3], {std::atof(argv[4]), std::atof(argv[5]), std::atof(argv[6])});
  else
    fail("cgal_mesh advancing-front|poisson IN.xyz OUT.off ...");
}
