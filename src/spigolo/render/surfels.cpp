// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/render/surfels.cpp
#include "spigolo/render/surfels.h"

#include <Eigen/Eigenvalues>

#include "spigolo/core/parallel.h"
#include "spigolo/index/neighborhoods.h"

namespace spigolo {
namespace {

constexpr std::size_t neighbors = 16;
constexpr std::size_t ring = 6;         // neighbors in the first ring round a point of a surface
constexpr int rounds = 4;               // of reweighting
constexpr double softness = 0.25;       // in spacings: points nearer to the plane count in full
constexpr double crease_spread = 0.08;  // of a plane fit, second to first: a crease, not noise
constexpr double crease_size = 0.6;  // discs there are smaller, or they stood out past the crease
constexpr double least = 0.35, most = 4;  // of the typical spacing

struct Plane {
  Vec3 normal;
  double spread = 0;  // variance across the plane, as a share of the smaller one along it
};

Plane fit_plane(std::span<const Vec3> near, std::span<const double> weights) {
  double sum = 0;
  Vec3 mean;
  for (std::size_t i = 0; i < near.size(); ++i) sum += weights[i], mean += weights[i] * near[i];
  mean = mean / sum;
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < near.size(); ++i) {
    const Vec3 d = near[i] - mean;
    const Eigen::Vector3d v(d.x, d.y, d.z);
    moments += weights[i] * v * v.transpose();
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(moments);
  const Eigen::Vector3d n = solver.eigenvectors().col(0);
  return {{n.x(), n.y(), n.z()}, solver.eigenvalues()[0] / solver.eigenvalues()[1]};
}

struct Surfel {
  Vec3 normal;
  double spacing = 0;
};

// On the plane most of the points lie on: least squares, reweighted by the distances from it.
// near[0] is the point itself.
Surfel fit_surfel(std::span<const Vec3> near) {
  const double reach = distance(near[0], near[std::min(ring, near.size() - 1)]);
  const double spacing = reach * std::sqrt(pi / (ring + 1));
  std::vector<double> weights(near.size(), 1.0);
  Plane plane = fit_plane(near, weights);
  const bool crease = plane.spread > crease_spread;
  for (int round = 1; round < rounds; ++round) {
    const double scale = softness * spacing * (rounds - round);
    for (std::size_t i = 0; i < near.size(); ++i) {
      const double d = dot(near[i] - near[0], plane.normal) / scale;
      weights[i] = 1 / ((1 + d * d) * (1 + d * d));
    }
    plane = fit_plane(near, weights);
  }
  return {is_finite(plane.normal) ? normalized(plane.normal) : Vec3{},
          crease ? crease_size * spacing : spacing};
}

void clamp_to_typical(std::vector<float>& spacings) {
  std::vector<float> sorted = spacings;
  std::erase_if(sorted, [](float s) { return !(s > 0); });
  if (sorted.empty()) return;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  const float typical = *middle;
  for (float& s : spacings)
    if (s > 0)
      s = std::clamp(s, static_cast<float>(least) * typical, static_cast<float>(most) * typical);
}

}  // namespace

Surfels find_surfels(std::span<const Vec3> points, const Job& job) {
  const OrderedCloud cloud = order_cloud(points, job);
  const KdTree tree(cloud);
  const Neighborhoods rows = find_neighborhoods(tree, neighbors, job);
  Surfels ordered{std::vector<float>(cloud.size()), std::vector<Vec3>(cloud.size())};
  parallel_for(job, "", rows.size(), 4096, [&](std::size_t begin, std::size_t end) {
    std::vector<Vec3> near;
    for (std::size_t i = begin; i < end; ++i) {
      near.assign(1, cloud.points[i]);
      for (const std::uint32_t j : rows.of(i)) near.push_back(cloud.points[j]);
      const Surfel surfel = fit_surfel(near);
      ordered.spacings[i] = static_cast<float>(surfel.spacing);
      ordered.normals[i] = surfel.normal;
    }
  });
  clamp_to_typical(ordered.spacings);
  Surfels surfels{std::vector<float>(points.size()), std::vector<Vec3>(points.size())};
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!is_finite(points[i])) continue;
    surfels.spacings[i] = ordered.spacings[cloud.rank[i]];
    surfels.normals[i] = ordered.normals[cloud.rank[i]];
  }
  return surfels;
}

}  // namespace spigolo
