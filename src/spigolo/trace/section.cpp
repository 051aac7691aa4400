// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/section.cpp
#include "spigolo/trace/section.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace spigolo {
namespace {

constexpr std::size_t rays = 72;                       // directions tried for a half plane
constexpr double angle_slack = radians(25);            // of the deviation that is known
constexpr double least_apart = radians(15);            // two half planes
constexpr double least_deviation = radians(6);         // of a crease
constexpr double clear_floor = 0.15, clear_noise = 2;  // [spacings]: nearer points may be either's
constexpr double gate_floor = 0.3, gate_noise = 3, gate_slope = 0.12;  // of points on a half plane
constexpr double curved_gain = 1.1;  // a quadric that fits so much better is the sheet
constexpr int fit_rounds = 5;
constexpr std::size_t least_points = 6, quadric_points = 14, exact_quadric_points = 9;
constexpr double nearest_side = 2.4;   // [spacings] a side comes so close to the crease
constexpr double beyond_share = 0.35;  // of points behind the crease to those in front
constexpr double worst_fit = 0.04;     // [spacings] residuals of a side that is none
constexpr double exact_noise = 0.03;   // [spacings] with less, six coefficients are certain
constexpr double exact_width = 1.6;    // [spacings] of the weights without noise
constexpr double rounding = 1e-7;      // [spacings]

// A point in the section's axes: along the crease and across it.
struct SectionPoint {
  double u, a, b;
};

// The sheet over one half plane: w = c0 + c1 v + c2 u + c3 vv + c4 uv + c5 uu, v along the ray.
struct Side {
  double ray_a = 1, ray_b = 0;  // unit, away from the crease
  Eigen::Matrix<double, 6, 1> c = Eigen::Matrix<double, 6, 1>::Zero();
  double rms = 0;
  std::size_t support = 0;

  double v(const SectionPoint& p) const { return p.a * ray_a + p.b * ray_b; }
  double w(const SectionPoint& p) const { return p.b * ray_a - p.a * ray_b; }
  double sheet(double u, double v) const {
    return c[0] + c[1] * v + c[2] * u + c[3] * v * v + c[4] * u * v + c[5] * u * u;
  }
  double off(const SectionPoint& p) const { return std::abs(w(p) - sheet(p.u, v(p))); }
};

class Section {
 public:
  Section(std::span<const Vec3> points, const SectionQuery& query)
      : query_(query),
        e_(any_perpendicular(query.direction)),
        f_(cross(query.direction, e_)),
        radius_(section_radius(query.noise)),
        clear_(clear_floor + clear_noise * query.noise) {
    for (const Vec3& p : points) {
      const Vec3 d = p - query.place;
      SectionPoint q{dot(d, query.direction), dot(d, e_), dot(d, f_)};
      q.a -= dot(query.bend, e_) * q.u * q.u / 2;  // beside the crease as it bends
      q.b -= dot(query.bend, f_) * q.u * q.u / 2;
      if (q.u < -query.behind || q.u > query.ahead) continue;
      if (q.a * q.a + q.b * q.b <= radius_ * radius_) points_.push_back(q);
    }
  }

  std::optional<SectionFit> run() {
    if (points_.size() < 2 * least_points || !find_rays()) return std::nullopt;
    if (!fit(side_[0], side_[1]) || !fit(side_[1], side_[0])) return std::nullopt;
    if (!ends_here(side_[0], side_[1]) || !ends_here(side_[1], side_[0])) return std::nullopt;
    return cross_sides();
  }

 private:
  double gate(double v) const {
    return gate_floor + gate_noise * query_.noise + gate_slope * std::max(0.0, v);
  }

  // Points near each of the directions round the crease; close ones tell no direction.
  std::array<double, rays> votes() const {
    std::array<double, rays> score{};
    const double width = 0.2 + 2 * query_.noise, far = 0.75 * radius_;
    for (const SectionPoint& p : points_) {
      const double rho = std::hypot(p.a, p.b);
      if (rho < clear_ || rho > far) continue;
      const double at = std::atan2(p.b, p.a), reach = std::asin(std::min(1.0, width / rho));
      const double step = 2 * pi / rays;
      const auto first = static_cast<int>(std::ceil((at - reach) / step));
      const auto last = static_cast<int>(std::floor((at + reach) / step));
      for (int k = first; k <= last; ++k) {
        const double off = rho * std::sin(k * step - at) / width;
        const int n = static_cast<int>(rays);
        score[static_cast<std::size_t>(((k % n) + n) % n)] += 1 - off * off;
      }
    }
    return score;
  }

  bool find_rays() {
    const auto score = votes();
    const double known = pi - query_.angle;
    double best = 0;
    std::array<std::size_t, 2> pair{};
    for (std::size_t i = 0; i < rays; ++i)
      for (std::size_t j = i + 1; j < rays; ++j) {
        const double turn = static_cast<double>(j - i) * 2 * pi / rays;
        const double apart = std::min(turn, 2 * pi - turn);
        if (apart < least_apart || std::abs(apart - known) > angle_slack) continue;
        const double both = score[i] + score[j] - 0.2 * std::abs(score[i] - score[j]);
        if (both > best) best = both, pair = {i, j};
      }
    if (best <= 0) return false;
    for (std::size_t s = 0; s < 2; ++s) {
      const double angle = static_cast<double>(pair[s]) * 2 * pi / rays;
      side_[s].ray_a = std::cos(angle);
      side_[s].ray_b = std::sin(angle);
    }
    return true;
  }

  // terms: 3 of a plane, 4 for one bent across the crease, 6 of a quadric.
  // Without noise nearer points count more, since no sheet is a quadric for long.
  double weight(const Side& side, const SectionPoint& p) const {
    if (query_.noise >= exact_noise) return 1;
    const double v = side.v(p);
    return std::exp(-(v * v + p.u * p.u) / (2 * exact_width * exact_width));
  }

  bool solve(Side& side, const std::vector<SectionPoint>& on, int n) const {
    Eigen::Matrix<double, 6, 6> m = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
    for (const SectionPoint& p : on) {
      const double v = side.v(p);
      Eigen::Matrix<double, 6, 1> row;
      row << 1, v, p.u, v * v, p.u * v, p.u * p.u;
      const double share = weight(side, p);
      m += share * row * row.transpose();
      right += share * row * side.w(p);
    }
    side.c.setZero();
    side.c.head(n) = m.topLeftCorner(n, n).ldlt().solve(right.head(n));
    double sum = 0, total = 0;
    for (const SectionPoint& p : on) {
      sum += weight(side, p) * side.off(p) * side.off(p);
      total += weight(side, p);
    }
    const double freedom = std::max(1.0, static_cast<double>(on.size()) - n);
    side.rms = std::sqrt(sum / total * static_cast<double>(on.size()) / freedom);
    side.support = on.size();
    return side.c.allFinite();
  }

  // Points of one side, off its sheet by no more than the limit and closer to it than to the other.
  std::vector<SectionPoint> points_on(const Side& side, const Side& other, double limit,
                                      double far) const {
    std::vector<SectionPoint> on;
    for (const SectionPoint& p : points_) {
      const double v = side.v(p), off = side.off(p);
      if (v < clear_ || v > far || off > std::min(limit, gate(v))) continue;
      if (other.v(p) > 0 && other.off(p) < off) continue;
      on.push_back(p);
    }
    return on;
  }

  static double median_off(const Side& side, const std::vector<SectionPoint>& on) {
    std::vector<double> off;
    for (const SectionPoint& p : on) off.push_back(side.off(p));
    const auto middle = off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2);
    std::nth_element(off.begin(), middle, off.end());
    return *middle;
  }

  bool fit(Side& side, const Side& other) const {
    double limit = infinity;
    for (int round = 0; round < fit_rounds; ++round) {
      const double far = round < 2 ? 0.75 * radius_ : radius_;
      const std::vector<SectionPoint> on = points_on(side, other, limit, far);
      if (on.size() < least_points) return false;
      Side flat = side, curved = side;
      if (!solve(flat, on, 3)) return false;
      const bool bent =
          round > 0 &&
          on.size() >= (query_.noise < exact_noise ? exact_quadric_points : quadric_points) &&
          solve(curved, on, query_.noise < exact_noise ? 6 : 4) &&
          flat.rms > curved_gain * curved.rms + rounding;
      side = bent ? curved : flat;
      limit = std::max(rounding, 4.5 * median_off(side, on) + rounding);
      if (round == 0) limit = infinity;
    }
    return side.rms < worst_fit + 1.6 * query_.noise;
  }

  // A side reaches the crease and has few points behind it that are not the other side's.
  bool ends_here(const Side& side, const Side& other) const {
    const double limit = std::max(0.12, 3 * query_.noise);
    double closest = infinity, front = 0, behind = 0;
    for (const SectionPoint& p : points_) {
      if (std::abs(p.u) > 2 + query_.noise || side.off(p) > limit) continue;
      const double v = side.v(p);
      if (v > 0) closest = std::min(closest, v);
      if (v > clear_ && v < clear_ + 1.2) front += 1;
      const bool others = other.v(p) > -0.3 && other.off(p) < limit;
      if (v < -clear_ - 0.3 && v > -clear_ - 1.5 && !others) behind += 1;
    }
    return closest < nearest_side + query_.noise && behind <= beyond_share * front + 0.5;
  }

  // Newton on the two profiles at u = 0.
  std::optional<SectionFit> cross_sides() const {
    double s = 0, t = 0;
    const Side &a = side_[0], &b = side_[1];
    const auto slope = [](const Side& side, double v) { return side.c[1] + 2 * side.c[3] * v; };
    const auto point = [](const Side& side, double v) {
      const double w = side.sheet(0, v);
      return Eigen::Vector2d(v * side.ray_a - w * side.ray_b, v * side.ray_b + w * side.ray_a);
    };
    const auto tangent = [&](const Side& side, double v) {
      const double w = slope(side, v);
      return Eigen::Vector2d(side.ray_a - w * side.ray_b, side.ray_b + w * side.ray_a);
    };
    for (int step = 0; step < 12; ++step) {
      Eigen::Matrix2d m;
      m << tangent(a, s), -tangent(b, t);
      if (std::abs(m.determinant()) < 0.05) return std::nullopt;
      const Eigen::Vector2d d = m.inverse() * (point(b, t) - point(a, s));
      s += d.x(), t += d.y();
      if (!(std::abs(s) < 3 && std::abs(t) < 3)) return std::nullopt;
    }
    const Eigen::Vector2d at = point(a, s), ra = tangent(a, s), rb = tangent(b, t);
    SectionFit fit;
    fit.place = query_.place + e_ * at.x() + f_ * at.y();
    fit.angle = pi - std::acos(std::clamp(ra.normalized().dot(rb.normalized()), -1.0, 1.0));
    if (fit.angle < least_deviation) return std::nullopt;
    const Vec3 along = cross(normal(a, s), normal(b, t));
    fit.direction = normalized(dot(along, query_.direction) < 0 ? -along : along);
    fit.rms = std::max(a.rms, b.rms);
    fit.support = std::min(a.support, b.support);
    return fit;
  }

  Vec3 normal(const Side& side, double v) const {
    const double dv = side.c[1] + 2 * side.c[3] * v, du = side.c[2] + side.c[4] * v;
    const Vec3 ray = e_ * side.ray_a + f_ * side.ray_b, up = f_ * side.ray_a - e_ * side.ray_b;
    return normalized(up - ray * dv - query_.direction * du);
  }

  SectionQuery query_;
  Vec3 e_, f_;
  double radius_, clear_;
  std::vector<SectionPoint> points_;
  std::array<Side, 2> side_;
};

}  // namespace

double section_radius(double noise) { return std::min(6.0, 3 + 6 * noise); }

std::optional<SectionFit> fit_section(std::span<const Vec3> points, const SectionQuery& query) {
  return Section(points, query).run();
}

}  // namespace spigolo
