// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/recognize.cpp
#include "spigolo/trace/recognize.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "spigolo/core/symmetric3.h"

namespace spigolo {
namespace {

constexpr int rounds = 20;         // of Gauss-Newton and reweighting
constexpr double tail = 2.4;       // Cauchy constant, as in local_fit.cpp
constexpr double to_sigma = 0.85;  // median distance in two dimensions to one standard deviation
constexpr double straight = 1e4;   // a radius of so many extents is a line

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Cauchy weights for distances, and their robust scale.
double reweigh(const std::vector<double>& miss, double exact, std::vector<double>& weight) {
  const double scale = std::max(exact, to_sigma * median(miss));
  for (std::size_t i = 0; i < miss.size(); ++i) {
    const double r = miss[i] / (tail * scale);
    weight[i] = 1 / (1 + r * r);
  }
  return scale;
}

Vec3 weighted_mean(std::span<const Vec3> places, const std::vector<double>& weight) {
  Vec3 sum;
  double total = 0;
  for (std::size_t i = 0; i < places.size(); ++i) sum += places[i] * weight[i], total += weight[i];
  return sum / total;
}

Symmetric3 weighted_spread(std::span<const Vec3> places, const std::vector<double>& weight,
                           const Vec3& about) {
  Symmetric3 spread;
  for (std::size_t i = 0; i < places.size(); ++i)
    spread.add((places[i] - about) * std::sqrt(weight[i]));
  return spread;
}

struct Flat {
  double x, y, z;  // in a frame of the circle
};

class CircleFitter {
 public:
  CircleFitter(std::span<const Vec3> places, double exact)
      : places_(places), exact_(exact), weight_(places.size(), 1), miss_(places.size()) {}

  std::optional<CircleFit> run() {
    if (places_.size() < 4 || !start()) return std::nullopt;
    for (int round = 0; round < rounds; ++round) {
      for (std::size_t i = 0; i < places_.size(); ++i) miss_[i] = fit_.distance(places_[i]);
      fit_.residual = reweigh(miss_, exact_, weight_);
      if (!improve()) return std::nullopt;
    }
    return fit_;
  }

 private:
  void set_frame() {
    e_ = any_perpendicular(fit_.axis);
    f_ = cross(fit_.axis, e_);
  }
  Flat flat(const Vec3& p) const {
    const Vec3 d = p - fit_.center;
    return {dot(d, e_), dot(d, f_), dot(d, fit_.axis)};
  }

  // Plane of least squares, in it the algebraic circle x^2 + y^2 = 2 a x + 2 b y + c.
  bool start() {
    const Vec3 mean = weighted_mean(places_, weight_);
    fit_.center = mean;
    fit_.axis = smallest_axis(weighted_spread(places_, weight_, mean)).axis;
    set_frame();
    Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    double extent = 0;
    for (const Vec3& p : places_) {
      const Flat q = flat(p);
      const Eigen::Vector3d row(2 * q.x, 2 * q.y, 1);
      const double square = q.x * q.x + q.y * q.y;
      extent = std::max(extent, square);
      m += row * row.transpose();
      right += row * square;
    }
    const Eigen::Vector3d s = m.ldlt().solve(right);
    const Vec3 along = largest_axis(weighted_spread(places_, weight_, mean)).axis;
    double width = 0;
    for (const Vec3& p : places_) width = std::max(width, squared_norm(cross(p - mean, along)));
    if (width * straight * straight < extent) return false;
    const double square = s.z() + s.x() * s.x() + s.y() * s.y();
    if (!s.allFinite() || !(square > 0) || square > straight * straight * extent) return false;
    fit_.radius = std::sqrt(square);
    fit_.center = mean + e_ * s.x() + f_ * s.y();
    return true;
  }

  // One step of Gauss-Newton: across the plane and within it are independent to first order.
  bool improve() {
    set_frame();
    Eigen::Matrix3d across = Eigen::Matrix3d::Zero(), within = across;
    Eigen::Vector3d off_plane = Eigen::Vector3d::Zero(), off_circle = off_plane;
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const Flat q = flat(places_[i]);
      const double r = std::hypot(q.x, q.y);
      if (!(r > 0)) continue;
      const Eigen::Vector3d a(1, q.x, q.y), w(q.x / r, q.y / r, 1);
      across += weight_[i] * a * a.transpose();
      off_plane += weight_[i] * q.z * a;
      within += weight_[i] * w * w.transpose();
      off_circle += weight_[i] * (r - fit_.radius) * w;
    }
    const Eigen::Vector3d tilt = across.ldlt().solve(off_plane);
    const Eigen::Vector3d shift = within.ldlt().solve(off_circle);
    if (!tilt.allFinite() || !shift.allFinite()) return false;
    fit_.center += fit_.axis * tilt.x() + e_ * shift.x() + f_ * shift.y();
    fit_.axis = normalized(fit_.axis - e_ * tilt.y() - f_ * tilt.z());
    fit_.radius += shift.z();
    return fit_.radius > 0 && is_finite(fit_.center);
  }

  std::span<const Vec3> places_;
  double exact_;
  std::vector<double> weight_, miss_;
  CircleFit fit_;
  Vec3 e_, f_;
};

}  // namespace

LineFit fit_line(std::span<const Vec3> places, double exact) {
  LineFit line;
  std::vector<double> weight(places.size(), 1), miss(places.size());
  for (int round = 0; round < rounds; ++round) {
    line.place = weighted_mean(places, weight);
    line.direction = largest_axis(weighted_spread(places, weight, line.place)).axis;
    for (std::size_t i = 0; i < places.size(); ++i)
      miss[i] = norm(cross(places[i] - line.place, line.direction));
    line.residual = reweigh(miss, exact, weight);
  }
  if (dot(line.direction, places.back() - places.front()) < 0) line.direction = -line.direction;
  return line;
}

double CircleFit::distance(const Vec3& p) const {
  const Vec3 d = p - center;
  const double z = dot(d, axis);
  return std::hypot(z, norm(d - axis * z) - radius);
}

Vec3 CircleFit::nearest(const Vec3& p) const {
  const Vec3 d = p - center;
  return center + normalized(d - axis * dot(d, axis)) * radius;
}

std::optional<CircleFit> fit_circle(std::span<const Vec3> places, double exact) {
  return CircleFitter(places, exact).run();
}

std::optional<CircleFit> circle_through(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 u = b - a, v = c - a, w = cross(u, v);
  const double square = squared_norm(w);
  if (!(square > 1e-20 * squared_norm(u) * squared_norm(v))) return std::nullopt;
  const Vec3 to_center =
      (cross(w, u) * squared_norm(v) + cross(v, w) * squared_norm(u)) / (2 * square);
  return CircleFit{a + to_center, normalized(w), norm(to_center), 0};
}

}  // namespace spigolo
