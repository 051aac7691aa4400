// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/cad/spline_rows.cpp
#include "spigolo/cad/spline_rows.h"

#include <utility>

#include "spigolo/core/error.h"

namespace spigolo {
namespace {

constexpr int degree = 3;
// Chords shorter than this share of the mean one count as this long: parameters stay apart.
constexpr double shortest_chord = 1e-6;

// Parameters of the stations from 0 to 1; closed: one more, that of the first station again.
std::vector<double> stations(std::span<const double> chords) {
  double total = 0;
  for (const double chord : chords) total += chord;
  if (!(total > 0)) throw Error("a spline needs points in different places");
  const double least = shortest_chord * total / static_cast<double>(chords.size());
  std::vector<double> t = {0};
  for (const double chord : chords) t.push_back(t.back() + std::max(chord, least));
  for (double& value : t) value /= t.back();
  t.back() = 1;
  return t;
}

// Double knots inside: first derivatives agree there.
std::vector<double> double_knots(const std::vector<double>& t) {
  std::vector<double> knots(4, t.front());
  for (std::size_t i = 1; i + 1 < t.size(); ++i) knots.insert(knots.end(), 2, t[i]);
  knots.insert(knots.end(), 4, t.back());
  return knots;
}

// Slope at the middle of three points by the parabola through them.
Vec3 middle_slope(const Vec3& a, const Vec3& b, const Vec3& c, double h0, double h1) {
  return ((b - a) * (h1 / h0) + (c - b) * (h0 / h1)) / (h0 + h1);
}

// One row of points with their slopes.
class Row {
 public:
  Row(std::vector<Vec3> points, const std::vector<double>& t, bool closed)
      : points_(std::move(points)), t_(t), closed_(closed) {}

  // Control points of the double-knot spline: 2 a station.
  std::vector<Vec3> poles() const {
    std::vector<Vec3> out = {points_.front()};
    const std::size_t last = points_.size() - 1;
    for (std::size_t i = 0; i <= last; ++i) {
      const Vec3 m = slope(i);
      if (i > 0) out.push_back(points_[i] - m * (step(i - 1) / 3));
      if (i < last) out.push_back(points_[i] + m * (step(i) / 3));
    }
    out.push_back(points_.back());
    return out;
  }

 private:
  double step(std::size_t i) const { return t_[i + 1] - t_[i]; }

  Vec3 slope(std::size_t i) const {
    const std::size_t last = points_.size() - 1;
    if (i > 0 && i < last)
      return middle_slope(points_[i - 1], points_[i], points_[i + 1], step(i - 1), step(i));
    if (closed_)
      return middle_slope(points_[last - 1], points_[0], points_[1], step(last - 1), step(0));
    if (last == 1) return (points_[1] - points_[0]) / step(0);
    // The parabola of the three outermost points, at its end.
    const std::size_t inner = i == 0 ? 1 : last - 1;
    const Vec3 chord = i == 0 ? (points_[1] - points_[0]) / step(0)
                              : (points_[last] - points_[last - 1]) / step(last - 1);
    return chord * 2 - slope(inner);
  }

  std::vector<Vec3> points_;
  const std::vector<double>& t_;
  bool closed_;
};

void require(std::size_t points, bool closed) {
  if (points < (closed ? 3u : 2u)) throw Error("a spline needs more points");
}

}  // namespace

NurbsCurve spline_through(std::span<const Vec3> points, bool closed) {
  require(points.size(), closed);
  std::vector<Vec3> row(points.begin(), points.end());
  if (closed) row.push_back(row.front());
  std::vector<double> chords;
  for (std::size_t i = 1; i < row.size(); ++i) chords.push_back(distance(row[i - 1], row[i]));
  const std::vector<double> t = stations(chords);
  return {degree, double_knots(t), Row(std::move(row), t, closed).poles(), {}};
}

NurbsSurface surface_through(std::span<const StripPoles> strips, bool closed,
                             std::vector<double>* station) {
  require(strips.size(), closed);
  const std::size_t n = strips.size(), count = n + (closed ? 1 : 0);
  std::vector<double> chords;
  for (std::size_t i = 1; i < count; ++i)
    chords.push_back((distance(strips[i - 1][0], strips[i % n][0]) +
                      distance(strips[i - 1][3], strips[i % n][3])) /
                     2);
  const std::vector<double> t = stations(chords);
  NurbsSurface surface;
  surface.knots_u = double_knots(t);
  surface.knots_v = {0, 0, 0, 0, 1, 1, 1, 1};
  surface.poles_u = 2 * count;
  surface.poles_v = 4;
  surface.poles.resize(surface.poles_u * 4);
  if (closed) surface.period_u = 1;
  for (std::size_t j = 0; j < 4; ++j) {
    std::vector<Vec3> row;
    for (std::size_t i = 0; i < count; ++i) row.push_back(strips[i % n][j]);
    const std::vector<Vec3> poles = Row(std::move(row), t, closed).poles();
    for (std::size_t i = 0; i < poles.size(); ++i) surface.poles[i * 4 + j] = poles[i];
  }
  if (station) station->assign(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(n));
  return surface;
}

}  // namespace spigolo
