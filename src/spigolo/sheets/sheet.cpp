// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/sheet.cpp
#include "spigolo/sheets/sheet.h"

#include <algorithm>
#include <cmath>

#include "spigolo/core/symmetric3.h"
#include "spigolo/sheets/heights.h"
#include "spigolo/sheets/normal_equations.h"

namespace spigolo {
namespace {

constexpr int plane_points = 3;
constexpr int quadric_freedom = 6, plane_freedom = 3;
// Curvature that the points do not determine (all on a line or two) is drawn to zero.
constexpr double curvature_weight = 1e-7;

struct Gradient {
  double u, v;
};

Gradient gradient(const Sheet& s, const FramePlace& q) {
  return {s.a[1] + 2 * s.a[3] * q.u + s.a[4] * q.v, s.a[2] + s.a[4] * q.u + 2 * s.a[5] * q.v};
}

double offset(const Sheet& s, const FramePlace& q) {
  return q.w -
         (s.a[0] + q.u * (s.a[1] + s.a[3] * q.u + s.a[4] * q.v) + q.v * (s.a[2] + s.a[5] * q.v));
}

template <class Function>
void for_each_used(std::span<const Vec3> points, std::span<const char> use, Function&& function) {
  for (std::size_t i = 0; i < points.size(); ++i)
    if (use.empty() || use[i]) function(points[i]);
}

// Frame with n across the direction of least spread, a0 the mean height.
void fit_plane(std::span<const Vec3> points, std::span<const char> use, Sheet& s) {
  Vec3 mean;
  for_each_used(points, use, [&](const Vec3& p) { mean += p - s.origin, ++s.support; });
  if (s.support < plane_points) return;
  mean = mean / s.support;
  Symmetric3 scatter;
  for_each_used(points, use,
                [&](const Vec3& p) { scatter.add((p - s.origin - mean) / s.spacing); });
  s.n = smallest_axis(scatter).axis;
  s.u = any_perpendicular(s.n);
  s.v = cross(s.n, s.u);
  s.a[0] = dot(mean, s.n) / s.spacing;
}

bool fit_quadric(std::span<const Vec3> points, std::span<const char> use, Sheet& s) {
  Matrix6 m{};
  std::array<double, 6> x{};
  for_each_used(points, use, [&](const Vec3& p) {
    const auto [u, v, w] = in_frame(s, p);
    const std::array<double, 6> row = {1, u, v, u * u, u * v, v * v};
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j <= i; ++j) m[i][j] += row[i] * row[j];
      x[i] += row[i] * w;
    }
  });
  double trace = 0;
  for (std::size_t i = 0; i < 6; ++i) trace += m[i][i];
  for (std::size_t i = 3; i < 6; ++i) m[i][i] += curvature_weight * trace;
  if (!solve(m, x)) return false;
  s.a = x;
  return true;
}

double weighted_deviation(const Sheet& s, std::span<const Vec3> points,
                          std::span<const double> weights, double total) {
  constexpr std::size_t at_once = 64;
  std::array<double, at_once> h;
  double squares = 0;
  for (std::size_t begin = 0; begin < points.size(); begin += at_once) {
    const std::size_t n = std::min(at_once, points.size() - begin);
    heights(s, points.subspan(begin, n), h.data());
    for (std::size_t i = 0; i < n; ++i)
      if (weights[begin + i] > 0) squares += weights[begin + i] * h[i] * h[i];
  }
  return std::sqrt(squares / total);
}

constexpr double flat_ridge = 1e-12;  // share of the weight: points on a line leave the tilt open

}  // namespace

double height(const Sheet& sheet, const Vec3& p) {
  const FramePlace q = in_frame(sheet, p);
  const Gradient g = gradient(sheet, q);
  return offset(sheet, q) / std::sqrt(1 + g.u * g.u + g.v * g.v);
}

Vec3 normal_at(const Sheet& sheet, const Vec3& p) {
  const Gradient g = gradient(sheet, in_frame(sheet, p));
  return normalized(sheet.n - sheet.u * g.u - sheet.v * g.v);
}

std::array<double, 2> curvatures_at(const Sheet& sheet, const Vec3& p) {
  const Gradient g = gradient(sheet, in_frame(sheet, p));
  const double e = 1 + g.u * g.u, f = g.u * g.v, h = 1 + g.v * g.v;  // first fundamental form
  const double area2 = e * h - f * f, length = std::sqrt(area2) * sheet.spacing;
  const double l = 2 * sheet.a[3] / length, m = sheet.a[4] / length, n = 2 * sheet.a[5] / length;
  const double mean = (e * n - 2 * f * m + h * l) / (2 * area2);
  const double gauss = (l * n - m * m) / area2;
  const double half = std::sqrt(std::max(0.0, mean * mean - gauss));
  return {mean + half, mean - half};
}

Sheet fit_sheet(std::span<const Vec3> points, std::span<const char> use, double spacing,
                SheetOrder order) {
  Sheet sheet;
  sheet.origin = points[0];
  sheet.spacing = spacing;
  fit_plane(points, use, sheet);
  if (sheet.support < plane_points) return {};
  const bool curved = order == SheetOrder::quadric && sheet.support >= quadric_points &&
                      fit_quadric(points, use, sheet);
  double squares = 0;
  for_each_used(points, use, [&](const Vec3& p) {
    const double h = height(sheet, p);
    squares += h * h;
  });
  const int freedom = sheet.support - (curved ? quadric_freedom : plane_freedom);
  sheet.deviation = freedom > 0 ? std::sqrt(squares / freedom) : infinity;
  return sheet;
}

Sheet fit_weighted_sheet(std::span<const Vec3> points, std::span<const double> weights,
                         const Vec3& origin, const Vec3& normal, double spacing, double ridge,
                         double plane_gain) {
  Sheet s;
  s.origin = origin;
  s.n = normal;
  s.u = any_perpendicular(normal);
  s.v = cross(s.n, s.u);
  s.spacing = spacing;
  Moments moments;
  int support = 0;
  double squares = 0;  // of the weights
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(weights[i] > 0)) continue;
    moments.add(weights[i], in_frame(s, points[i]));
    squares += weights[i] * weights[i];
    ++support;
  }
  if (support < plane_points) return {};
  Matrix6 m = moments.matrix();
  s.a = moments.w;
  add_ridge(m, ridge * moments.uv[0]);
  const bool curved = support >= quadric_points && solve(m, s.a);
  if (curved) s.deviation = weighted_deviation(s, points, weights, moments.uv[0]);
  if (!curved || plane_gain > 0) {
    Sheet plane = s;
    m = moments.matrix();
    plane.a = moments.w;
    for (std::size_t i = 1; i < 3; ++i) m[i][i] += flat_ridge * moments.uv[0];
    if (!solve(m, plane.a, 3)) return {};
    plane.a[3] = plane.a[4] = plane.a[5] = 0;
    plane.deviation = weighted_deviation(plane, points, weights, moments.uv[0]);
    const double effective = moments.uv[0] * moments.uv[0] / squares;
    if (!curved || plane.deviation * plane.deviation <=
                       s.deviation * s.deviation * (1 + plane_gain / effective))
      s = plane;
  }
  s.support = support;
  return s;
}

}  // namespace spigolo
