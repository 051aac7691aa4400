// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/index/noise.cpp
#include "spigolo/index/noise.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "spigolo/core/parallel.h"
#include "spigolo/index/flattest_half.h"
#include "spigolo/index/sample.h"

namespace spigolo {
namespace {

constexpr std::size_t plane_k = 8, quadric_k = 16;
constexpr std::size_t max_looks = 20000;
constexpr std::size_t halves_share = 4;  // one look in four is enough for the flattest halves
constexpr std::size_t grain = 256;
// Lower quartile of sqrt(chi^2_m / m): m = 9 - 3 for the plane, 17 - 6 for the quadric.
constexpr double plane_quartile = 0.7588, quadric_quartile = 0.8303;

// The flattest half of 16 neighbors, normal noise: measured on planes, 1.94 to 2.04 (no closed
// form).
constexpr double half_factor = 2.0;
// Where the noise comes near the width of the neighborhoods, these are balls of points rather than
// slabs, and the direction of least spread is chosen among several alike: the estimate bends down
// towards a limit. Measured on planes and boxes, random and blue-noise samples, up to 1.2 spacings;
// off by at most a tenth. The factor is for the lower quartile where the local spacing scatters.
constexpr double saturation = 0.62, saturation_power = 6, most_saturated = 0.94;
constexpr double scatter_factor = 1.04;
// That much is looked at again in wider neighborhoods, which bend down later (measured in the same
// way): of even samples shaken across the surface only, small ones are balls that spread the same
// in all directions, and the correction overshoots.
constexpr double much = 0.4;
constexpr std::size_t wide_k = 64, wide_looks = 2000;
constexpr double wide_quartile = 0.937, wide_saturation = 1.35;

Eigen::Vector3d eigen(const Vec3& v) { return {v.x, v.y, v.z}; }

// Rows: the point and its first k neighbors around their mean, in spacings, turned so that the last
// column is the direction of least spread.
Eigen::MatrixX3d in_own_frame(std::span<const Vec3> points, std::size_t i,
                              std::span<const std::uint32_t> neighbors, double spacing) {
  Eigen::MatrixX3d rows(static_cast<Eigen::Index>(neighbors.size() + 1), 3);
  rows.row(0).setZero();
  Eigen::Index r = 1;
  for (const std::uint32_t j : neighbors)
    rows.row(r++) = eigen((points[j] - points[i]) / spacing).transpose();
  const Eigen::RowVector3d mean = rows.colwise().mean();
  rows.rowwise() -= mean;
  const Eigen::Matrix3d covariance = rows.transpose() * rows;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  return rows * solver.eigenvectors().rowwise().reverse();
}

double plane_deviation(const Eigen::MatrixX3d& rows) {
  return std::sqrt(rows.col(2).squaredNorm() / static_cast<double>(rows.rows() - 3));
}

double quadric_deviation(const Eigen::MatrixX3d& rows) {
  const auto u = rows.col(0).array(), v = rows.col(1).array();
  Eigen::MatrixXd basis(rows.rows(), 6);
  basis.col(0).setOnes();
  basis.col(1) = u;
  basis.col(2) = v;
  basis.col(3) = u * u;
  basis.col(4) = u * v;
  basis.col(5) = v * v;
  const Eigen::VectorXd residual =
      rows.col(2) - basis * basis.colPivHouseholderQr().solve(rows.col(2));
  return std::sqrt(residual.squaredNorm() / static_cast<double>(rows.rows() - 6));
}

double half_deviation(std::span<const Vec3> points, std::size_t i,
                      std::span<const std::uint32_t> neighbors, double spacing) {
  std::array<Vec3, half_of> offset;
  for (std::size_t t = 0; t < half_of; ++t)
    offset[t] = (points[neighbors[t]] - points[i]) / spacing;
  return flattest_half(offset);
}

double lower_quartile(std::vector<double>& values) {
  const auto it = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 4);
  std::nth_element(values.begin(), it, values.end());
  return *it;
}

// The noise that makes small neighborhoods deviate so much [spacings].
double unbend(double deviation, double limit) {
  const double share = std::min(deviation / limit, most_saturated);
  return deviation / (1 - std::pow(share, saturation_power));
}

// From the quadrics of wide neighborhoods.
double estimate_wide_noise(std::span<const Vec3> points, const KdTree& tree, const Spacing& spacing,
                           const Job& job) {
  const std::vector<std::uint32_t> looks = sample_points(spacing, wide_looks);
  std::vector<double> deviation(looks.size());
  parallel_for(job, "", looks.size(), grain, [&](std::size_t begin, std::size_t end) {
    std::vector<Neighbor> found;
    std::vector<std::uint32_t> row;
    for (std::size_t look = begin; look < end; ++look) {
      const std::uint32_t i = looks[look];
      tree.nearest(points[i], wide_k + 1, found);
      row.clear();
      for (const Neighbor& n : found)
        if (n.index != i) row.push_back(n.index);
      deviation[look] = quadric_deviation(in_own_frame(points, i, row, spacing.of_point[i]));
    }
  });
  return unbend(lower_quartile(deviation) / wide_quartile, wide_saturation);
}

}  // namespace

double noise_of_flattest_half(std::span<const Vec3> points, std::size_t i,
                              std::span<const std::uint32_t> row, double spacing) {
  return half_factor * half_deviation(points, i, row.first(half_of), spacing);
}

double estimate_noise(std::span<const Vec3> points, const Neighborhoods& neighborhoods,
                      const Spacing& spacing, const KdTree& tree, const Job& job) {
  if (neighborhoods.k < quadric_k || points.size() < 4 * quadric_k || spacing.of_cloud == 0)
    return 0;
  const std::vector<std::uint32_t> looks = sample_points(spacing, max_looks);
  const std::vector<std::uint32_t> few = sample_points(spacing, looks.size() / halves_share);
  std::vector<double> plane(looks.size()), quadric(looks.size()), half(few.size());
  parallel_for(job, "", looks.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t look = begin; look < end; ++look) {
      const auto row = neighborhoods.of(looks[look]);
      const double s = spacing.of_point[looks[look]];
      plane[look] = plane_deviation(in_own_frame(points, looks[look], row.first(plane_k), s));
      quadric[look] = quadric_deviation(in_own_frame(points, looks[look], row.first(quadric_k), s));
    }
  });
  parallel_for(job, "", few.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t look = begin; look < end; ++look)
      half[look] = half_deviation(points, few[look], neighborhoods.of(few[look]).first(quadric_k),
                                  spacing.of_point[few[look]]);
  });
  const double least =
      std::min({lower_quartile(plane) / plane_quartile, lower_quartile(quadric) / quadric_quartile,
                lower_quartile(half) * half_factor});
  const double noise = scatter_factor * unbend(least, saturation);
  if (noise < much || points.size() <= wide_k) return noise;
  return std::min(noise, estimate_wide_noise(points, tree, spacing, job));
}

}  // namespace spigolo
