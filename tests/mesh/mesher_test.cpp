// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// tests/mesh/mesher_test.cpp - sharp meshes of shapes whose surface and creases are known exactly
#include "spigolo/mesh/mesher.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "spigolo/core/error.h"
#include "spigolo/index/order.h"
#include "spigolo/mesh/shading.h"
#include "spigolo/synth/synth.h"

namespace spigolo {
namespace {

// The exact creases of a shape, as polylines between its corners.
FeatureCurves exact_network(const Shape& shape, std::size_t pieces) {
  FeatureCurves network;
  for (const Corner& corner : shape.corners) network.corners.push_back({corner.position, 0});
  for (const ExactCrease& crease : shape.creases) {
    FeatureCurve curve;
    curve.closed = crease.curve.closed;
    for (std::size_t i = 0; i < pieces + (curve.closed ? 0 : 1); ++i)
      curve.points.push_back(crease.curve.at(static_cast<double>(i) / static_cast<double>(pieces)));
    curve.angle.assign(curve.points.size(), 1);
    for (std::size_t end = 0; end < 2 && !curve.closed; ++end) {
      Vec3& p = end == 0 ? curve.points.front() : curve.points.back();
      for (std::size_t c = 0; c < network.corners.size(); ++c)
        if (distance(network.corners[c].position, p) < 1e-9) {
          p = network.corners[c].position;
          curve.corner[end] = static_cast<std::int32_t>(c);
          ++network.corners[c].valence;
        }
    }
    network.curves.push_back(curve);
  }
  validate(network);
  return network;
}

// Of a flat face the distance grows by the size of a component of the normal along each axis, and
// fastest along the normal.
Vec3 exact_normal(const Shape& shape, const Vec3& p, double spacing) {
  const double step = 1e-4 * spacing;
  Vec3 size, best;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Vec3 q = p;
    q[axis] += step;
    size[axis] = surface_distance(shape, q);
    q[axis] -= 2 * step;
    size[axis] = std::max(size[axis], surface_distance(shape, q));
  }
  double farthest = -1;
  for (int signs = 0; signs < 4; ++signs) {
    const Vec3 n = normalized({size.x, signs & 1 ? -size.y : size.y, signs & 2 ? -size.z : size.z});
    const double reached =
        std::max(surface_distance(shape, p + step * n), surface_distance(shape, p - step * n));
    if (reached > farthest) farthest = reached, best = n;
  }
  return best;
}

// Samples with the exact normal of their patch.
struct Case {
  SurfacePoints surface;
  FeatureCurves network;
  Shape shape;
};

Case make_case(const std::string& shape, Sampling sampling, std::size_t points, double size = 4) {
  SynthOptions options;
  options.size = size;
  options.shape = shape;
  options.sampling = sampling;
  options.points = points;
  const SynthCloud cloud = make_cloud(options);
  Case c{{}, exact_network(cloud.shape, 60), cloud.shape};
  c.surface.spacing = std::sqrt(area(cloud.shape) / static_cast<double>(cloud.cloud.size()));
  c.surface.disagreement *= c.surface.spacing;
  const OrderedCloud ordered = order_cloud(cloud.cloud.points);
  for (const Vec3& p : ordered.points)
    c.surface.points.push_back(
        {p + ordered.origin, exact_normal(cloud.shape, p + ordered.origin, c.surface.spacing), 0});
  return c;
}

void expect_closed(const SharpMesh& sharp, long long euler) {
  const MeshCheck check = check_mesh(sharp.mesh, sharp.creases);  // all of it again
  EXPECT_TRUE(check.sound());
  EXPECT_TRUE(check.closed());
  EXPECT_EQ(check.euler, euler);
  EXPECT_EQ(check.components, 1U);
  EXPECT_EQ(check.crease_edges_kept, check.crease_edges);
  EXPECT_GT(check.volume, 0);
}

double farthest_middle(const SharpMesh& sharp, const Shape& shape) {
  double largest = 0;
  const auto& p = sharp.mesh.vertices.points;
  for (const auto& [a, b, c] : sharp.mesh.triangles)
    largest = std::max(largest, surface_distance(shape, (p[a] + p[b] + p[c]) / 3));
  return largest;
}

// The sides of a plate or the chamfers of a box, whose samples say nothing or, misled, have the
// normal of another sheet.
SharpMesh mesh_without(const std::function<bool(const Vec3& normal)>& strip, Case& c, bool misled) {
  for (SurfaceFoot& foot : c.surface.points)
    if (strip(foot.normal)) foot.normal = misled ? Vec3{0, 0, 1} : Vec3{};
  return build_mesh(c.surface, c.network);
}

TEST(Mesher, StripsBetweenTwoCreasesNeedNoSamples) {
  const auto side = [](const Vec3& n) { return std::abs(n.z) < 0.5; };
  const auto chamfer = [](const Vec3& n) {
    return std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)}) < 0.9;
  };
  for (const bool misled : {false, true})
    for (const double width : {1.0, 1.4}) {
      Case plate = make_case("plate", Sampling::blue, 2000, width);
      const SharpMesh thin = mesh_without(side, plate, misled);
      expect_closed(thin, 2);
      EXPECT_LT(farthest_middle(thin, plate.shape), 0.05 * plate.surface.spacing) << width;
      Case box = make_case("chamfer-box", Sampling::blue, 4000, width);
      const SharpMesh cut = mesh_without(chamfer, box, misled);
      expect_closed(cut, 2);
      EXPECT_LT(farthest_middle(cut, box.shape), 0.05 * box.surface.spacing) << width;
    }
}

TEST(Mesher, CubesOfAnySamplingAreSharpAndWatertight) {
  for (const Sampling sampling : {Sampling::lattice, Sampling::blue, Sampling::random}) {
    const Case c = make_case("cube", sampling, 1500);
    const SharpMesh sharp = build_mesh(c.surface, c.network);
    expect_closed(sharp, 2);
    EXPECT_LT(farthest_middle(sharp, c.shape), 1e-3 * c.surface.spacing);
    EXPECT_NEAR(sharp.check.volume, std::pow(area(c.shape) / 6, 1.5), 1e-6 * sharp.check.volume);
    EXPECT_NEAR(sharp.check.area, area(c.shape), 1e-6 * sharp.check.area);
  }
}

TEST(Mesher, CreasesThatRunInwardAndThinWalls) {
  for (const char* shape : {"l-prism", "star", "slot", "steps"}) {
    const Case c = make_case(shape, Sampling::blue, 3000);
    const SharpMesh sharp = build_mesh(c.surface, c.network);
    expect_closed(sharp, 2);
    EXPECT_LT(farthest_middle(sharp, c.shape), 0.05 * c.surface.spacing) << shape;
  }
}

TEST(Mesher, AnOpenSurfaceKeepsItsBorder) {
  const Case c = make_case("wedge", Sampling::blue, 2000);
  const SharpMesh sharp = build_mesh(c.surface, c.network);
  const MeshCheck check = check_mesh(sharp.mesh, sharp.creases);
  EXPECT_TRUE(check.sound());
  EXPECT_EQ(check.border_loops, 1U);
  EXPECT_EQ(check.euler, 1);
  EXPECT_EQ(check.crease_edges_kept, check.crease_edges);
  EXPECT_LT(farthest_middle(sharp, c.shape), 0.01 * c.surface.spacing);  // no bridge
}

TEST(Mesher, NothingDependsOnThreads) {
  const Case c = make_case("l-prism", Sampling::random, 2000);
  Job one, four;
  one.threads = 1, four.threads = 4;
  const SharpMesh a = build_mesh(c.surface, c.network, {}, one);
  const SharpMesh b = build_mesh(c.surface, c.network, {}, four);
  EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
  EXPECT_TRUE(std::equal(a.mesh.vertices.points.begin(), a.mesh.vertices.points.end(),
                         b.mesh.vertices.points.begin(), b.mesh.vertices.points.end()));
}

TEST(Mesher, LongerEdgesFewerTriangles) {
  const Case c = make_case("cube", Sampling::blue, 3000);
  MesherOptions coarse;
  coarse.edge_length = 2;
  const SharpMesh fine = build_mesh(c.surface, c.network),
                  few = build_mesh(c.surface, c.network, coarse);
  expect_closed(few, 2);
  EXPECT_LT(3 * few.check.triangles, fine.check.triangles);
}

TEST(Mesher, BadOptionsAndEmptyInput) {
  const Case c = make_case("cube", Sampling::blue, 300);
  MesherOptions bad;
  bad.edge_length = 0;
  EXPECT_THROW(build_mesh(c.surface, c.network, bad), UsageError);
  SurfacePoints nothing;
  EXPECT_THROW(build_mesh(nothing, {}), NoResultError);
}

// Points left out may be noise, and a crease in the air a mistake; many of both are no surface.
TEST(Mesher, ManyPointsAndCreasesLeftOutAreRefused) {
  Case c = make_case("cube", Sampling::blue, 1500);
  const double h = c.surface.spacing;
  const auto far = [&](std::size_t i) {
    return Vec3{100 + 5 * static_cast<double>(i) * h, 10, 10};
  };
  for (std::size_t i = 0; i < c.surface.points.size() / 10; ++i) c.surface.loose.push_back(far(i));
  const SharpMesh sharp = build_mesh(c.surface, c.network);
  EXPECT_EQ(sharp.uncovered, c.surface.loose.size());
  FeatureCurve in_air;
  for (std::size_t i = 0; i < 200; ++i) in_air.points.push_back(far(i));
  in_air.angle.assign(in_air.points.size(), 1);
  c.network.curves.push_back(in_air);
  EXPECT_THROW(build_mesh(c.surface, c.network), NoResultError);
  c.surface.loose.clear();
  EXPECT_EQ(build_mesh(c.surface, c.network).uncovered, 0U);
}

TEST(Shading, ACubeHasSixPatchesWithFlatNormals) {
  const Case c = make_case("cube", Sampling::lattice, 600);
  const SharpMesh sharp = build_mesh(c.surface, c.network);
  const auto patch = find_patches(sharp.mesh, sharp.creases);
  EXPECT_EQ(*std::max_element(patch.begin(), patch.end()), 5U);
  for (const auto& corners : corner_normals(sharp.mesh, sharp.creases))
    for (const Vec3& n : corners)
      EXPECT_NEAR(std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)}), 1, 1e-6);
}

}  // namespace
}  // namespace spigolo
