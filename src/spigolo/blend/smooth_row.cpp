// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/smooth_row.cpp
#include "spigolo/blend/smooth_row.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace spigolo {
namespace {

constexpr double widest = 3;  // [standard deviations] of the mean

// The row as its mean sees it: round and round if closed, mirrored in its ends if not.
class Row {
 public:
  Row(const std::vector<Vec3>& points, bool closed)
      : points_(points), n_(static_cast<std::ptrdiff_t>(points.size())), closed_(closed) {}

  std::ptrdiff_t size() const { return n_; }
  Vec3 at(std::ptrdiff_t i) const {
    if (closed_) return points_[static_cast<std::size_t>((i % n_ + n_) % n_)];
    if (i < 0) return points_.front() * 2 - inner(-i);
    if (i >= n_) return points_.back() * 2 - inner(2 * (n_ - 1) - i);
    return inner(i);
  }
  // Half of the way to both neighbors.
  double part(std::ptrdiff_t i) const {
    return (distance(at(i - 1), at(i)) + distance(at(i), at(i + 1))) / 2;
  }

 private:
  Vec3 inner(std::ptrdiff_t i) const {
    return points_[static_cast<std::size_t>(std::clamp(i, std::ptrdiff_t{0}, n_ - 1))];
  }

  const std::vector<Vec3>& points_;
  std::ptrdiff_t n_;
  bool closed_;
};

std::vector<Vec3> gaussian_mean(const std::vector<Vec3>& points, double sigma, bool closed) {
  const Row row(points, closed);
  std::vector<Vec3> out;
  for (std::ptrdiff_t i = 0; i < row.size(); ++i) {
    double weight = row.part(i);
    Vec3 sum = row.at(i) * weight;
    for (const std::ptrdiff_t step : {1, -1}) {
      double way = 0;
      for (std::ptrdiff_t k = 1; k < row.size() / 2; ++k) {
        const std::ptrdiff_t j = i + k * step;
        way += distance(row.at(j - step), row.at(j));
        if (way > widest * sigma) break;
        const double w = row.part(j) * std::exp(-way * way / (2 * sigma * sigma));
        sum += row.at(j) * w, weight += w;
      }
    }
    out.push_back(weight > 0 ? sum / weight : row.at(i));
  }
  return out;
}

}  // namespace

std::vector<Vec3> round_corners(const std::vector<Vec3>& row, double sigma, bool closed) {
  const std::vector<Vec3> once = gaussian_mean(row, sigma, closed),
                          twice = gaussian_mean(once, sigma, closed);
  std::vector<Vec3> out;
  for (std::size_t i = 0; i < row.size(); ++i) out.push_back(once[i] * 2 - twice[i]);
  return out;
}

}  // namespace spigolo
