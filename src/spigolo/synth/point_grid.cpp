// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/synth/point_grid.cpp - points in hashed cells
#include "spigolo/synth/point_grid.h"

#include <bit>

namespace spigolo {
namespace {

constexpr std::uint32_t none = 0xffffffff;

}  // namespace

PointGrid::PointGrid(double cell, std::size_t capacity)
    : cell_(cell), head_(std::bit_ceil(2 * capacity + 1), none) {
  points_.reserve(capacity);
  next_.reserve(capacity);
}

PointGrid::Cell PointGrid::cell_of(const Vec3& p) const {
  auto index = [&](double x) { return static_cast<std::int64_t>(std::floor(x / cell_)); };
  return {index(p.x), index(p.y), index(p.z)};
}

std::size_t PointGrid::bucket(const Cell& c) const {
  std::uint64_t h = static_cast<std::uint64_t>(c.x) * 0x9e3779b97f4a7c15u;
  h = (h ^ (h >> 32) ^ static_cast<std::uint64_t>(c.y)) * 0xbf58476d1ce4e5b9u;
  h = (h ^ (h >> 32) ^ static_cast<std::uint64_t>(c.z)) * 0x94d049bb133111ebu;
  return static_cast<std::size_t>(h ^ (h >> 31)) & (head_.size() - 1);
}

void PointGrid::insert(const Vec3& p) {
  const std::size_t b = bucket(cell_of(p));
  next_.push_back(head_[b]);
  head_[b] = static_cast<std::uint32_t>(points_.size());
  points_.push_back(p);
}

/// Calls visit(index) for every point in the cells the ball meets, for some others too and for some
/// twice (cells that share a bucket), until it returns false.
template <class Visit>
void PointGrid::visit_ball(const Vec3& p, double r, const Visit& visit) const {
  const Cell low = cell_of(p - Vec3{r, r, r}), high = cell_of(p + Vec3{r, r, r});
  for (std::int64_t x = low.x; x <= high.x; ++x)
    for (std::int64_t y = low.y; y <= high.y; ++y)
      for (std::int64_t z = low.z; z <= high.z; ++z)
        for (std::uint32_t i = head_[bucket({x, y, z})]; i != none; i = next_[i])
          if (!visit(std::size_t{i})) return;
}

bool PointGrid::any_within(const Vec3& p, double r) const {
  bool found = false;
  visit_ball(p, r, [&](std::size_t j) {
    found = squared_distance(p, points_[j]) < r * r;
    return !found;
  });
  return found;
}

double PointGrid::nearest_other(std::size_t i) const {
  double best = infinity;
  for (double r = cell_ / 2; r <= 32 * cell_; r *= 2) {
    visit_ball(points_[i], r, [&](std::size_t j) {
      if (j != i) best = std::min(best, squared_distance(points_[i], points_[j]));
      return true;
    });
    if (best <= r * r) break;  // nothing outside of the ball is nearer
  }
  return std::sqrt(best);
}

}  // namespace spigolo
