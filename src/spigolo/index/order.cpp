// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/index/order.cpp
#include "spigolo/index/order.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <string>
#include <tuple>
#include <utility>

#include "spigolo/core/error.h"
#include "spigolo/core/parallel.h"

namespace spigolo {
namespace {

constexpr std::size_t grain = 1 << 15;
constexpr int bits_per_axis = 21;

struct Key {
  std::uint64_t code;
  std::uint32_t index;
};

// Two zero bits between the bits of a 21-bit number.
std::uint64_t spread_bits(std::uint64_t v) {
  v = (v | v << 32) & 0x001f00000000ffffu;
  v = (v | v << 16) & 0x001f0000ff0000ffu;
  v = (v | v << 8) & 0x100f00f00f00f00fu;
  v = (v | v << 4) & 0x10c30c30c30c30c3u;
  v = (v | v << 2) & 0x1249249249249249u;
  return v;
}

// Cells of the bounding cube, the same for every axis so that scaling and shifting change nothing.
// Half a cell is added: the middle of a symmetric shape then lies inside a cell, not on a border.
class Curve {
 public:
  explicit Curve(const Box& box) : min_(box.min) {
    const Vec3 size = box.size();
    const double extent = std::max({size.x, size.y, size.z});
    scale_ = extent > 0 ? ((1 << bits_per_axis) - 2) / extent : 0.0;
  }
  std::uint64_t code(const Vec3& p) const {
    return spread_bits(cell(p.x - min_.x)) << 2 | spread_bits(cell(p.y - min_.y)) << 1 |
           spread_bits(cell(p.z - min_.z));
  }

 private:
  std::uint64_t cell(double offset) const {
    return static_cast<std::uint64_t>(offset * scale_ + 0.5);
  }
  Vec3 min_;
  double scale_ = 0;
};

// Least significant digit first, 11 bits at a time: stable, and linear in the number of keys.
void radix_sort(std::vector<Key>& keys) {
  constexpr int digit_bits = 11;
  constexpr std::size_t digits = std::size_t{1} << digit_bits;
  std::vector<Key> other(keys.size());
  for (int shift = 0; shift < 3 * bits_per_axis; shift += digit_bits) {
    std::array<std::size_t, digits> start{};
    for (const Key& key : keys) ++start[key.code >> shift & (digits - 1)];
    std::size_t sum = 0;
    for (std::size_t& s : start) sum += std::exchange(s, sum);
    for (const Key& key : keys) other[start[key.code >> shift & (digits - 1)]++] = key;
    keys.swap(other);
  }
}

// Points that share a cell of the curve, by their coordinates.
void sort_within_cells(std::vector<Key>& keys, std::span<const Vec3> points) {
  const auto coordinates = [&](const Key& key) {
    const Vec3& p = points[key.index];
    return std::tuple(p.x, p.y, p.z);
  };
  for (std::size_t begin = 0; begin < keys.size();) {
    std::size_t end = begin + 1;
    while (end < keys.size() && keys[end].code == keys[begin].code) ++end;
    if (end - begin > 1)
      std::sort(keys.begin() + static_cast<std::ptrdiff_t>(begin),
                keys.begin() + static_cast<std::ptrdiff_t>(end),
                [&](const Key& a, const Key& b) { return coordinates(a) < coordinates(b); });
    begin = end;
  }
}

std::vector<Key> sorted_keys(std::span<const Vec3> points, const Job& job) {
  std::vector<std::uint32_t> finite;
  finite.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    if (is_finite(points[i])) finite.push_back(static_cast<std::uint32_t>(i));
  const Curve curve(bounding_box(points));
  std::vector<Key> keys(finite.size());
  parallel_for(job, "order", keys.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) keys[i] = {curve.code(points[finite[i]]), finite[i]};
  });
  radix_sort(keys);
  sort_within_cells(keys, points);
  return keys;
}

}  // namespace

OrderedCloud order_cloud(std::span<const Vec3> points, const Job& job) {
  if (points.size() >= no_point)
    throw UsageError(
        "a cloud of " + std::to_string(points.size()) +
        " points is beyond the 4 294 967 294 that one run can hold; cut it into tiles");
  OrderedCloud cloud;
  const Box box = bounding_box(points);
  cloud.origin = box.empty() ? Vec3{} : box.center();
  cloud.rank.assign(points.size(), no_point);
  const std::vector<Key> keys = sorted_keys(points, job);
  cloud.points.reserve(keys.size());
  cloud.codes.reserve(keys.size());
  const Vec3* last = nullptr;
  for (const Key& key : keys) {
    const Vec3& p = points[key.index];
    if (!last || !(*last == p)) {
      cloud.points.push_back(p - cloud.origin);
      cloud.codes.push_back(key.code);
    }
    last = &p;
    cloud.rank[key.index] = static_cast<std::uint32_t>(cloud.points.size() - 1);
  }
  cloud.non_finite = points.size() - keys.size();
  cloud.duplicates = keys.size() - cloud.points.size();
  return cloud;
}

void validate(const OrderedCloud& cloud) {
  if (cloud.codes.size() != cloud.size()) throw Error("ordered cloud: one code a point is needed");
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!is_finite(cloud.points[i])) throw Error("ordered cloud: a point is not finite");
    if (i > 0 && cloud.codes[i] < cloud.codes[i - 1]) throw Error("ordered cloud: not in order");
    if (i > 0 && cloud.points[i] == cloud.points[i - 1])
      throw Error("ordered cloud: a point stands twice");
  }
  for (const std::uint32_t r : cloud.rank)
    if (r != no_point && r >= cloud.size()) throw Error("ordered cloud: a rank does not exist");
}

}  // namespace spigolo
