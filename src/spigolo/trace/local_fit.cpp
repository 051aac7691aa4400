// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/local_fit.cpp
#include "spigolo/trace/local_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

namespace spigolo {
namespace {

constexpr int rounds = 6;           // of reweighting
constexpr double tail = 2.4;        // Cauchy constant: 95 % efficient for normal residuals
constexpr double to_sigma = 0.85;   // median distance in two dimensions to one standard deviation
constexpr double least_extent = 1;  // [units of the samples] shorter pieces tell no bend

struct Row {
  double u, a, b;  // along the direction, and across it
};

struct Coefficients {
  Eigen::Matrix<double, 3, 2> c = Eigen::Matrix<double, 3, 2>::Zero();

  double miss(const Row& r) const {
    const double a = c(0, 0) + r.u * (c(1, 0) + r.u * c(2, 0)) - r.a;
    const double b = c(0, 1) + r.u * (c(1, 1) + r.u * c(2, 1)) - r.b;
    return std::hypot(a, b);
  }
};

Coefficients solve(const std::vector<Row>& rows, const std::vector<double>& weight, int degree) {
  Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
  Eigen::Matrix<double, 3, 2> right = Eigen::Matrix<double, 3, 2>::Zero();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Eigen::Vector3d base(1, rows[i].u, rows[i].u * rows[i].u);
    m += weight[i] * base * base.transpose();
    right += weight[i] * base * Eigen::RowVector2d(rows[i].a, rows[i].b);
  }
  Coefficients result;
  const int n = degree + 1;
  result.c.topRows(n) = m.topLeftCorner(n, n).ldlt().solve(right.topRows(n));
  if (!result.c.allFinite()) result.c.setZero();
  return result;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

int possible_degree(const std::vector<Row>& rows, int wanted) {
  const auto [first, last] = std::minmax_element(
      rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.u < b.u; });
  const double extent = last->u - first->u;
  if (rows.size() < 2 || extent < 0.25 * least_extent) return 0;
  return rows.size() < 4 || extent < least_extent ? std::min(wanted, 1) : wanted;
}

}  // namespace

LocalCurve fit_local_curve(std::span<const Vec3> samples, const Vec3& origin, const Vec3& direction,
                           const LocalFitOptions& options) {
  LocalCurve curve{origin, direction, {}, 0, 0};
  if (samples.empty()) return curve;
  const Vec3 e = any_perpendicular(direction), f = cross(direction, e);
  std::vector<Row> rows;
  for (const Vec3& p : samples) {
    const Vec3 d = p - origin;
    rows.push_back({dot(d, direction), dot(d, e), dot(d, f)});
  }
  const int degree = possible_degree(rows, options.degree);
  std::vector<double> weight(rows.size(), 1), miss(rows.size());
  Coefficients fit;
  double scale = 0;
  for (int round = 0; round < rounds; ++round) {
    fit = solve(rows, weight, degree);
    for (std::size_t i = 0; i < rows.size(); ++i) miss[i] = fit.miss(rows[i]);
    scale = std::max(options.exact, to_sigma * median(miss));
    if (*std::max_element(miss.begin(), miss.end()) <= options.exact) break;  // nothing to weigh
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double r = miss[i] / (tail * scale);
      weight[i] = 1 / (1 + r * r);
    }
  }
  const auto across = [&](int row) { return e * fit.c(row, 0) + f * fit.c(row, 1); };
  curve.place = origin + across(0);
  curve.tangent = normalized(direction + across(1));
  const Vec3 bend = across(2) * 2;
  curve.bend = bend - curve.tangent * dot(bend, curve.tangent);
  curve.residual = scale;
  curve.support = static_cast<int>(
      std::count_if(weight.begin(), weight.end(), [](double w) { return w >= 0.5; }));
  return curve;
}

Vec3 cubic_between(const CurveEnd& a, const CurveEnd& b, double t) {
  const double half_turn = std::sqrt(std::max(0.0, (1 + dot(a.along, b.along)) / 2));  // cosine
  const double speed = distance(a.place, b.place) * 2 / (1 + half_turn), r = 1 - t;
  return a.place * (r * r * (1 + 2 * t)) + a.along * (speed * t * r * r) +
         b.place * (t * t * (3 - 2 * t)) - b.along * (speed * t * t * r);
}

}  // namespace spigolo
