// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/hinge.cpp
#include "spigolo/sheets/hinge.h"

#include <algorithm>
#include <cmath>

#include "spigolo/core/symmetric3.h"

namespace spigolo {
namespace {

constexpr std::size_t fewest = 16;
constexpr int angles = 8, offsets = 9, halvings = 4;  // lines tried first, then steps to the best
constexpr double offset_share = 0.8;                  // of the radius: lines beyond say nothing
// Of squared residuals, in variances. A hundred lines are tried, some ten of them independent, on
// every third point: chance must be rarer than one in ten thousand, curvature leaves something too.
constexpr double significant = 27, worth_a_look = 16;
constexpr double rounder = 3;  // so much better a rounded fold is a bend
// [spacings] of the rounded folds, as hyperbolas: fillets, and curvature
// that a quadric does not follow.
constexpr std::array<double, 3> rounds = {1.5, 3.5, 8};
constexpr double poor_fit = 1.7;  // [standard deviations] of what is more than one fold
constexpr double freedom = 9;     // of quadric, fold, angle and offset
// A fold this sharp has two heights over the plane, or is the end of a thin plate with both walls.
constexpr double sharpest = radians(115);
constexpr double dependent = 1e-9;  // share of a column left by the others

double dot_product(const double* a, const double* b, std::size_t n) {
  std::array<double, 4> sum{};
  std::size_t i = 0;
  for (; i + 4 <= n; i += 4)
    for (std::size_t l = 0; l < 4; ++l) sum[l] += a[i + l] * b[i + l];
  for (; i < n; ++i) sum[0] += a[i] * b[i];
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

void subtract(double* a, const double* b, double factor, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) a[i] -= factor * b[i];
}

// A fold that tangential noise has blurred, or a fillet: |s| with a round tip.
double fold_at(double s, double roundness) { return std::sqrt(s * s + roundness * roundness); }

}  // namespace

void HingeTest::set_frame(std::span<const Vec3> points, double spacing) {
  n_ = points.size();
  Vec3 mean;
  for (const Vec3& p : points) mean += (p - points[0]) / static_cast<double>(n_);
  Symmetric3 scatter;
  for (const Vec3& p : points) scatter.add((p - points[0] - mean) / spacing);
  normal_ = smallest_axis(scatter).axis;
  u_ = any_perpendicular(normal_);
  v_ = cross(normal_, u_);
  for (std::vector<double>* column : {&x_, &y_, &w_}) column->resize(n_);
  radius_ = 0;
  for (std::size_t i = 0; i < n_; ++i) {
    const Vec3 d = (points[i] - points[0]) / spacing;
    x_[i] = dot(d, u_), y_[i] = dot(d, v_), w_[i] = dot(d, normal_);
    radius_ = std::max(radius_, x_[i] * x_[i] + y_[i] * y_[i]);
  }
  radius_ = std::sqrt(radius_);
}

// Gram-Schmidt on the terms of a quadric; false if the points do not determine one.
bool HingeTest::set_basis() {
  basis_.resize(terms * n_);
  for (std::size_t i = 0; i < n_; ++i) {
    const double x = x_[i], y = y_[i];
    const Terms row = {1, x, y, x * x, x * y, y * y};
    for (std::size_t t = 0; t < terms; ++t) basis_[t * n_ + i] = row[t];
  }
  rest_ = w_;
  for (std::size_t t = 0; t < terms; ++t) {
    double* column = &basis_[t * n_];
    const double before = dot_product(column, column, n_);
    for (std::size_t q = 0; q < t; ++q) {
      upper_[q][t] = dot_product(&basis_[q * n_], column, n_);
      subtract(column, &basis_[q * n_], upper_[q][t], n_);
    }
    const double left = dot_product(column, column, n_);
    if (!(left > dependent * before)) return false;
    upper_[t][t] = std::sqrt(left);
    for (std::size_t i = 0; i < n_; ++i) column[i] /= upper_[t][t];
    fitted_[t] = dot_product(column, rest_.data(), n_);
    subtract(rest_.data(), column, fitted_[t], n_);
  }
  rest_squares_ = dot_product(rest_.data(), rest_.data(), n_);
  return true;
}

// Least squares with the fold as a seventh term: the quadric is in both models, so only what the
// basis leaves of the fold counts.
HingeTest::Gain HingeTest::gain_of(const Line& line, double roundness) const {
  const double c = std::cos(line.angle), s = std::sin(line.angle);
  double squares = 0, common = 0;
  Gain gain;
  for (std::size_t i = 0; i < n_; ++i) {
    const double f = fold_at(c * x_[i] + s * y_[i] - line.offset, roundness);
    squares += f * f;
    common += f * rest_[i];
    for (std::size_t t = 0; t < terms; ++t) gain.shared[t] += f * basis_[t * n_ + i];
  }
  const double all = squares;
  for (const double share : gain.shared) squares -= share * share;
  if (!(squares > dependent * all)) return gain;
  gain.slope = common / squares;
  gain.squares = common * common / squares;
  return gain;
}

// The same for all offsets of one angle, from the sums in bins.
void HingeTest::offer_offsets(double angle, std::span<const double> roundness,
                              std::span<Line> best) const {
  for (int o = 0; o < offsets; ++o) {
    const double offset = offset_share * radius_ * (2.0 * o / (offsets - 1) - 1);
    for (std::size_t r = 0; r < roundness.size(); ++r) {
      std::array<double, terms + 1> sums{};
      double squares = 0;
      for (std::size_t b = 0; b < bins; ++b) {
        const double at = (static_cast<double>(b) + 0.5) * bin_width_ - radius_;
        const double f = fold_at(at - offset, roundness[r]);
        squares += binned_[0][b] * f * f;
        for (std::size_t t = 0; t <= terms; ++t) sums[t] += binned_[t + 1][b] * f;
      }
      const double all = squares;
      for (std::size_t t = 1; t <= terms; ++t) squares -= sums[t] * sums[t];
      if (!(squares > dependent * all)) continue;
      const double gain = sums[0] * sums[0] / squares;
      if (gain > best[r].gain) best[r] = {angle, offset, gain};
    }
  }
}

void HingeTest::find_coarse(std::span<const double> roundness, std::span<Line> best) {
  bin_width_ = 2 * radius_ / bins;
  for (int a = 0; a < angles; ++a) {
    const double angle = pi * a / angles, c = std::cos(angle), s = std::sin(angle);
    for (auto& row : binned_) row.fill(0);
    for (std::size_t i = 0; i < n_; ++i) {
      const double place = (c * x_[i] + s * y_[i] + radius_) / bin_width_;
      const auto b = std::min(bins - 1, static_cast<std::size_t>(std::max(0.0, place)));
      binned_[0][b] += 1;
      binned_[1][b] += rest_[i];
      for (std::size_t t = 0; t < terms; ++t) binned_[t + 2][b] += basis_[t * n_ + i];
    }
    offer_offsets(angle, roundness, best);
  }
}

HingeTest::Line HingeTest::refined(Line line, double roundness) const {
  line.gain = gain_of(line, roundness).squares;
  double turn = pi / angles / 2, move = offset_share * radius_ / (offsets - 1);
  for (int h = 0; h < halvings; ++h, turn /= 2, move /= 2) {
    for (const auto& [dt, dm] : {std::array{turn, 0.0}, std::array{0.0, move}}) {
      const Line at = line;
      for (const double sign : {-1.0, 1.0}) {
        Line other{at.angle + sign * dt, at.offset + sign * dm};
        if (std::abs(other.offset) > offset_share * radius_) continue;
        other.gain = gain_of(other, roundness).squares;
        if (other.gain > line.gain) line = other;
      }
    }
  }
  return line;
}

// The sharp fold under the blurred one: the quadric where the line passes the first point.
Hinge HingeTest::place(const Line& line, const Gain& fold, const Vec3& origin,
                       double spacing) const {
  Terms a;
  for (std::size_t t = terms; t-- > 0;) {
    a[t] = fitted_[t] - fold.slope * fold.shared[t];
    for (std::size_t q = t + 1; q < terms; ++q) a[t] -= upper_[t][q] * a[q];
    a[t] /= upper_[t][t];
  }
  const double c = std::cos(line.angle), s = std::sin(line.angle);
  const double x = line.offset * c, y = line.offset * s;
  const double gx = a[1] + 2 * a[3] * x + a[4] * y, gy = a[2] + a[4] * x + 2 * a[5] * y;
  const double height = a[0] + x * (a[1] + a[3] * x + a[4] * y) + y * (a[2] + a[5] * y);
  Hinge hinge;
  hinge.fold = Fold::edge;
  hinge.point = origin + (u_ * x + v_ * y + normal_ * height) * spacing;
  hinge.direction = normalized(v_ * c - u_ * s + normal_ * (gy * c - gx * s));
  for (std::size_t side = 0; side < 2; ++side) {
    const double sign = side == 0 ? 1 : -1;
    const Vec3 away = (u_ * c + v_ * s) * sign + normal_ * (sign * (gx * c + gy * s) + fold.slope);
    hinge.into[side] = normalized(away - hinge.direction * dot(away, hinge.direction));
  }
  hinge.deviation = pi - angle_between(hinge.into[0], hinge.into[1]);
  return hinge;
}

Hinge HingeTest::find(std::span<const Vec3> points, double spacing) {
  if (points.size() < fewest) return {};
  set_frame(points, spacing);
  if (!set_basis()) return {};
  const double blur = std::sqrt(2 / pi) * noise_;  // mean of |s| at s = 0, for normal noise
  const std::array<double, 4> roundness = {blur, blur + rounds[0], blur + rounds[1],
                                           blur + rounds[2]};
  std::array<Line, 4> best;
  find_coarse(roundness, best);
  const double known = noise_ * noise_, count = static_cast<double>(n_);
  if (best[0].gain < worth_a_look * known && rest_squares_ < poor_fit * poor_fit * known * count)
    return {};
  const Line sharp = refined(best[0], blur);
  const double variance = std::max(known, (rest_squares_ - sharp.gain) / (count - freedom));
  Hinge hinge;
  if (variance > poor_fit * poor_fit * known) hinge.fold = Fold::unclear;
  if (hinge.fold == Fold::unclear || sharp.gain < significant * variance) return hinge;
  for (std::size_t r = 1; r < roundness.size(); ++r) {
    const Line round = refined(best[r], roundness[r]);
    if (round.gain <= sharp.gain + rounder * variance) continue;
    hinge = place(round, gain_of(round, roundness[r]), points[0], spacing);
    hinge.fold = hinge.deviation > sharpest ? Fold::unclear : Fold::bend;
    return hinge;
  }
  hinge = place(sharp, gain_of(sharp, blur), points[0], spacing);
  if (hinge.deviation > sharpest) hinge.fold = Fold::unclear;
  return hinge;
}

}  // namespace spigolo
