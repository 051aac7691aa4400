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
constexpr std::size_t offsets = 9;    // lines tried first at each angle
constexpr int halvings = 4;           // then steps to the best
constexpr double offset_share = 0.8;  // of the radius: lines beyond say nothing
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
constexpr double upright = 1e-3;    // share of its length that gives a direction in the plane
constexpr double dependent = 1e-9;  // share of a column left by the others

double dot_product(const double* a, const double* b, std::size_t n) {
  std::array<double, 4> sum{};
  std::size_t i = 0;
  for (; i + 4 <= n; i += 4)
    for (std::size_t l = 0; l < 4; ++l) sum[l] += a[i + l] * b[i + l];
  for (; i < n; ++i) sum[0] += a[i] * b[i];
  return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

// The lines that are tried are turned from here, so they must turn with the cloud.
Vec3 in_plane(const Vec3& d, const Vec3& normal) {
  const Vec3 level = d - normal * dot(d, normal);
  return norm(level) > upright * norm(d) ? normalized(level) : any_perpendicular(normal);
}

void subtract(double* a, const double* b, double factor, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) a[i] -= factor * b[i];
}

}  // namespace

double HingeTest::angle_of(std::size_t a) { return pi * static_cast<double>(a) / angles; }

void HingeTest::set_frame(std::span<const Vec3> points, double spacing) {
  n_ = points.size();
  Vec3 mean;
  for (const Vec3& p : points) mean += (p - points[0]) / static_cast<double>(n_);
  Symmetric3 scatter;
  for (const Vec3& p : points) scatter.add((p - points[0] - mean) / spacing);
  normal_ = smallest_axis(scatter).axis;
  u_ = in_plane(points.back() - points[0], normal_);
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
  rows_.resize(n_);
  for (std::size_t i = 0; i < n_; ++i) {
    rows_[i][0] = 1;
    rows_[i][1] = rest_[i];
    for (std::size_t t = 0; t < terms; ++t) rows_[i][t + 2] = basis_[t * n_ + i];
  }
  return true;
}

// Least squares with the fold as a seventh term: the quadric is in both models, so only what the
// basis leaves of the fold counts.
HingeTest::Gain HingeTest::gain_of(const FoldRow& sums) {
  Gain gain;
  double squares = sums[0];
  for (std::size_t t = 0; t < terms; ++t) {
    gain.shared[t] = sums[t + 2];
    squares -= gain.shared[t] * gain.shared[t];
  }
  if (!(squares > dependent * sums[0])) return gain;
  gain.slope = sums[1] / squares;
  gain.squares = sums[1] * sums[1] / squares;
  return gain;
}

HingeTest::Gain HingeTest::gain_of(const Line& line, double roundness) {
  const double c = std::cos(line.angle), s = std::sin(line.angle);
  heights_.resize(n_);
  for (std::size_t i = 0; i < n_; ++i) heights_[i] = c * x_[i] + s * y_[i] - line.offset;
  fold_heights(heights_, roundness);
  FoldRow sums;
  sum_folds(rows_, heights_, {&sums, 1});
  return gain_of(sums);
}

void HingeTest::fill_bins() {
  bin_width_ = 2 * radius_ / bins;
  bin_.resize(n_);
  for (std::size_t a = 0; a < angles; ++a) {
    const double angle = angle_of(a), c = std::cos(angle), s = std::sin(angle);
    for (std::size_t i = 0; i < n_; ++i) {
      const double place = (c * x_[i] + s * y_[i] + radius_) / bin_width_;
      bin_[i] = std::min<std::uint32_t>(bins - 1, static_cast<std::uint32_t>(std::max(0.0, place)));
    }
    binned_[a].fill({});
    add_to_bins(rows_, bin_, binned_[a]);
  }
}

// The best of a hundred lines, from the sums in bins: the heights of a fold there are the same for
// all angles.
HingeTest::Line HingeTest::coarse(double roundness) {
  std::array<double, offsets> offset;
  for (std::size_t o = 0; o < offsets; ++o)
    offset[o] = offset_share * radius_ * (2.0 * static_cast<double>(o) / (offsets - 1) - 1);
  heights_.resize(bins * offsets);
  for (std::size_t b = 0; b < bins; ++b) {
    const double at = (static_cast<double>(b) + 0.5) * bin_width_ - radius_;
    for (std::size_t o = 0; o < offsets; ++o) heights_[b * offsets + o] = at - offset[o];
  }
  fold_heights(heights_, roundness);
  Line best;
  std::array<FoldRow, offsets> sums;
  for (std::size_t a = 0; a < angles; ++a) {
    sum_folds(binned_[a], heights_, sums);
    for (std::size_t o = 0; o < offsets; ++o) {
      const double gain = gain_of(sums[o]).squares;
      if (gain > best.gain) best = {angle_of(a), offset[o], gain};
    }
  }
  return best;
}

HingeTest::Line HingeTest::refined(Line line, double roundness) {
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
  fill_bins();
  const Line best = coarse(blur);
  const double known = noise_ * noise_, count = static_cast<double>(n_);
  if (best.gain < worth_a_look * known && rest_squares_ < poor_fit * poor_fit * known * count)
    return {};
  const Line sharp = refined(best, blur);
  const double variance = std::max(known, (rest_squares_ - sharp.gain) / (count - freedom));
  Hinge hinge;
  if (variance > poor_fit * poor_fit * known) hinge.fold = Fold::unclear;
  if (hinge.fold == Fold::unclear || sharp.gain < significant * variance) return hinge;
  for (const double wider : rounds) {
    const double roundness = blur + wider;
    const Line round = refined(coarse(roundness), roundness);
    if (round.gain <= sharp.gain + rounder * variance) continue;
    hinge = place(round, gain_of(round, roundness), points[0], spacing);
    hinge.fold = hinge.deviation > sharpest ? Fold::unclear : Fold::bend;
    return hinge;
  }
  hinge = place(sharp, gain_of(sharp, blur), points[0], spacing);
  if (hinge.deviation > sharpest) hinge.fold = Fold::unclear;
  return hinge;
}

}  // namespace spigolo
