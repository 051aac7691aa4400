// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/spline.cpp
#include "spigolo/trace/spline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "spigolo/core/error.h"

namespace spigolo {
namespace {

constexpr std::size_t degree = 3;
constexpr std::size_t band = degree + 1;
constexpr int most_rounds = 64;     // of adding knots
constexpr std::size_t lead = 8;     // points a closed curve is fitted beyond its seam
constexpr double stiffness = 1e-6;  // keeps spans with few points solvable

using Basis = std::array<double, band>;

// The span [knots[i], knots[i+1]) that holds t, the last one for the end of the range.
std::size_t span_of(const std::vector<double>& knots, std::size_t poles, double t) {
  const auto begin = knots.begin() + degree,
             end = knots.begin() + static_cast<std::ptrdiff_t>(poles);
  const auto above = std::upper_bound(begin, end, t);
  return static_cast<std::size_t>(above - knots.begin()) - 1;
}

// The basis functions that are not zero on a span (Cox, de Boor).
Basis basis_at(const std::vector<double>& knots, std::size_t span, double t) {
  Basis n{};
  n[0] = 1;
  for (std::size_t d = 1; d <= degree; ++d) {
    double saved = 0;
    for (std::size_t r = 0; r < d; ++r) {
      const double right = knots[span + r + 1], left = knots[span + 1 + r - d];
      const double share = right > left ? n[r] / (right - left) : 0;
      n[r] = saved + (right - t) * share;
      saved = (t - left) * share;
    }
    n[d] = saved;
  }
  return n;
}

// Symmetric band matrix, lower half: row i holds columns i - 3 .. i.
class BandSystem {
 public:
  explicit BandSystem(std::size_t n) : matrix_(n, Basis{}), right_(n) {}

  void add(std::size_t row, std::size_t column, double value) {
    if (column <= row) matrix_[row][column + degree - row] += value;
  }
  void add_right(std::size_t row, const Vec3& value) { right_[row] += value; }
  // Row and column become those of the unit matrix: the unknown is `value`.
  void fix(std::size_t k, const Vec3& value) {
    for (std::size_t other = k > degree ? k - degree : 0;
         other < std::min(matrix_.size(), k + degree + 1); ++other) {
      if (other == k) continue;
      double& entry = matrix_[std::max(other, k)][std::min(other, k) + degree - std::max(other, k)];
      right_[other] -= value * std::exchange(entry, 0.0);
    }
    matrix_[k][degree] = 1;
    right_[k] = value;
  }
  // Cholesky, in place.
  std::vector<Vec3> solve() {
    const std::size_t n = matrix_.size();
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i > degree ? i - degree : 0; j <= i; ++j) {
        double sum = matrix_[i][j + degree - i];
        for (std::size_t k = i > degree ? i - degree : 0; k < j; ++k)
          if (k + degree >= j) sum -= matrix_[i][k + degree - i] * matrix_[j][k + degree - j];
        matrix_[i][j + degree - i] =
            j < i ? sum / matrix_[j][degree] : std::sqrt(std::max(sum, 1e-300));
      }
    }
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = i > degree ? i - degree : 0; k < i; ++k)
        right_[i] -= right_[k] * matrix_[i][k + degree - i];
      right_[i] = right_[i] / matrix_[i][degree];
    }
    for (std::size_t i = n; i-- > 0;) {
      for (std::size_t k = i + 1; k < std::min(n, i + degree + 1); ++k)
        right_[i] -= right_[k] * matrix_[k][i + degree - k];
      right_[i] = right_[i] / matrix_[i][degree];
    }
    return std::move(right_);
  }

 private:
  std::vector<Basis> matrix_;
  std::vector<Vec3> right_;
};

std::vector<double> chord_parameters(std::span<const Vec3> points) {
  std::vector<double> t(points.size(), 0);
  for (std::size_t i = 1; i < t.size(); ++i)
    t[i] = t[i - 1] + std::max(distance(points[i], points[i - 1]), 1e-12);
  return t;
}

std::vector<double> clamped_knots(const std::vector<double>& inner, double end) {
  std::vector<double> knots(band, 0.0);
  knots.insert(knots.end(), inner.begin(), inner.end());
  knots.insert(knots.end(), band, end);
  return knots;
}

CurveSpline solve(std::span<const Vec3> points, const std::vector<double>& t,
                  const std::vector<double>& inner) {
  CurveSpline spline;
  spline.knots = clamped_knots(inner, t.back());
  const std::size_t n = spline.knots.size() - band;
  BandSystem system(n);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t span = span_of(spline.knots, n, t[i]);
    const Basis b = basis_at(spline.knots, span, t[i]);
    for (std::size_t r = 0; r < band; ++r) {
      system.add_right(span - degree + r, points[i] * b[r]);
      for (std::size_t c = 0; c < band; ++c)
        system.add(span - degree + r, span - degree + c, b[r] * b[c]);
    }
  }
  // A pole differs little from the mean of its neighbors where the points leave it open.
  for (std::size_t k = 1; k + 1 < n; ++k) {
    const std::array<double, 3> row = {-0.5, 1, -0.5};
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = 0; c < 3; ++c)
        system.add(k - 1 + r, k - 1 + c, stiffness * row[r] * row[c]);
  }
  system.fix(0, points.front());
  system.fix(n - 1, points.back());
  spline.poles = system.solve();
  return spline;
}

// Halves every span with a point farther off than tolerance, if each half holds two or more: with
// fewer the spline swings between them.
bool refine(std::span<const Vec3> points, const std::vector<double>& t, const CurveSpline& spline,
            double tolerance, std::vector<double>& inner) {
  std::vector<double> added;
  const std::size_t n = spline.poles.size();
  for (std::size_t i = 0; i < points.size();) {
    const std::size_t span = span_of(spline.knots, n, t[i]);
    const double middle = (spline.knots[span] + spline.knots[span + 1]) / 2;
    double worst = 0;
    std::array<std::size_t, 2> count{};
    for (; i < points.size() && span_of(spline.knots, n, t[i]) == span; ++i) {
      worst = std::max(worst, distance(points[i], value(spline, t[i])));
      ++count[t[i] < middle ? 0 : 1];
    }
    if (worst > tolerance && std::min(count[0], count[1]) >= 2) added.push_back(middle);
  }
  inner.insert(inner.end(), added.begin(), added.end());
  std::sort(inner.begin(), inner.end());
  return !added.empty();
}

CurveSpline fit_open(std::span<const Vec3> points, double tolerance) {
  const std::vector<double> t = chord_parameters(points);
  std::vector<double> inner;
  CurveSpline spline = solve(points, t, inner);
  for (int round = 0; round < most_rounds && refine(points, t, spline, tolerance, inner); ++round)
    spline = solve(points, t, inner);
  return spline;
}

std::size_t multiplicity(const CurveSpline& spline, double t) {
  return static_cast<std::size_t>(std::count(spline.knots.begin(), spline.knots.end(), t));
}

// The part of a spline between two parameters, clamped at both.
CurveSpline part(CurveSpline spline, double from, double to) {
  for (const double t : {from, to})
    while (multiplicity(spline, t) < degree) insert_knot(spline, t);
  const auto first = std::lower_bound(spline.knots.begin(), spline.knots.end(), from);
  const auto last = std::upper_bound(spline.knots.begin(), spline.knots.end(), to);
  CurveSpline result;
  result.knots.push_back(from);
  result.knots.insert(result.knots.end(), first, last);
  result.knots.push_back(to);
  const auto pole = first - spline.knots.begin() - 1;
  const auto count = static_cast<std::ptrdiff_t>(result.knots.size() - band);
  result.poles.assign(spline.poles.begin() + pole, spline.poles.begin() + pole + count);
  for (double& knot : result.knots) knot -= from;
  return result;
}

}  // namespace

double first_parameter(const CurveSpline& spline) { return spline.knots.front(); }
double last_parameter(const CurveSpline& spline) { return spline.knots.back(); }

Vec3 value(const CurveSpline& spline, double t) {
  t = std::clamp(t, first_parameter(spline), last_parameter(spline));
  const std::size_t span = span_of(spline.knots, spline.poles.size(), t);
  const Basis b = basis_at(spline.knots, span, t);
  Vec3 sum;
  for (std::size_t r = 0; r < band; ++r) sum += spline.poles[span - degree + r] * b[r];
  return sum;
}

void insert_knot(CurveSpline& spline, double t) {
  const std::size_t span = span_of(spline.knots, spline.poles.size(), t);
  std::vector<Vec3> poles(spline.poles.size() + 1);
  for (std::size_t i = 0; i < poles.size(); ++i) {
    if (i + degree <= span) {
      poles[i] = spline.poles[i];
    } else if (i > span) {
      poles[i] = spline.poles[i - 1];
    } else {
      const double left = spline.knots[i], right = spline.knots[i + degree];
      const double share = right > left ? (t - left) / (right - left) : 0;
      poles[i] = spline.poles[i - 1] * (1 - share) + spline.poles[i] * share;
    }
  }
  spline.poles = std::move(poles);
  spline.knots.insert(spline.knots.begin() + static_cast<std::ptrdiff_t>(span) + 1, t);
}

CurveSpline fit_spline(std::span<const Vec3> points, bool closed, double tolerance) {
  if (points.size() < (closed ? 3U : 2U)) throw Error("a spline needs two points, closed three");
  if (!closed) return fit_open(points, tolerance);
  const std::size_t n = points.size(), more = std::min(lead, n);
  std::vector<Vec3> round;
  for (std::size_t i = 0; i < n + 2 * more + 1; ++i) round.push_back(points[(i + n - more) % n]);
  const std::vector<double> t = chord_parameters(round);
  CurveSpline spline = part(fit_open(round, tolerance), t[more], t[more + n]);
  spline.poles.front() = spline.poles.back() = (spline.poles.front() + spline.poles.back()) / 2;
  return spline;
}

}  // namespace spigolo
