// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/index/order.cpp
#include "spigolo/index/order.h"

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

#include "spigolo/core/error.h"
#include "spigolo/core/parallel.h"
#include "spigolo/index/radix_sort.h"

namespace spigolo {
namespace {

constexpr std::size_t grain = 1 << 15;
constexpr int bits_per_axis = 21;
// Fourth powers of lengths, as fits sum them up, are still numbers.
constexpr double smallest_size = 1e-70, largest_size = 1e70;

// Two zero bits between the bits of a 21-bit number.
std::uint64_t spread_bits(std::uint64_t v) {
  v = (v | v << 32) & 0x001f00000000ffffu;
  v = (v | v << 16) & 0x001f0000ff0000ffu;
  v = (v | v << 8) & 0x100f00f00f00f00fu;
  v = (v | v << 4) & 0x10c30c30c30c30c3u;
  v = (v | v << 2) & 0x1249249249249249u;
  return v;
}

double largest_side(const Box& box) {
  const Vec3 size = box.size();
  return std::max({size.x, size.y, size.z});
}

// Cells of the bounding cube, the same for every axis so that scaling and shifting change nothing.
// Half a cell is added: the middle of a symmetric shape then lies inside a cell, not on a border.
class Curve {
 public:
  explicit Curve(const Box& box) : min_(box.min) {
    const double extent = largest_side(box);
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

Box finite_box(std::span<const Vec3> points, const Job& job) {
  const auto boxes = parallel_collect<Box>(
      job, points.size(), grain, [&](std::size_t begin, std::size_t end, auto& found) {
        found.push_back(bounding_box(points.subspan(begin, end - begin)));
      });
  Box all;
  for (const Box& box : boxes) {
    if (box.empty()) continue;
    all.add(box.min);
    all.add(box.max);
  }
  return all;
}

// The points of the input and where they are from the origin of the cloud. Places that differ by
// less than that can hold are one.
struct Shifted {
  std::span<const Vec3> points;
  Vec3 origin;

  Vec3 at(const CodeKey& key) const { return points[key.index] - origin; }
};

// Sorts each run of keys that are alike in the sorted bits: by what is left of the code, then by
// the coordinates; copies of a place in the order of the input.
void sort_runs(std::vector<CodeKey>& keys, const Shifted& cloud, int sorted_from, const Job& job) {
  const auto before = [&](const CodeKey& a, const CodeKey& b) {
    if (a.code != b.code) return a.code < b.code;
    const Vec3 p = cloud.at(a), q = cloud.at(b);
    return std::tuple(p.x, p.y, p.z, a.index) < std::tuple(q.x, q.y, q.z, b.index);
  };
  const auto run_of = [&](std::size_t i) { return keys[i].code >> sorted_from; };
  // A run belongs to the range it begins in.
  std::vector<std::size_t> first((keys.size() + grain - 1) / grain + 1, keys.size());
  parallel_for(job, "", keys.size(), grain, [&](std::size_t begin, std::size_t) {
    std::size_t i = begin;
    while (i > 0 && i < keys.size() && run_of(i) == run_of(i - 1)) ++i;
    first[begin / grain] = i;
  });
  parallel_for(job, "", keys.size(), grain, [&](std::size_t begin, std::size_t) {
    const std::size_t end = first[begin / grain + 1];
    for (std::size_t i = first[begin / grain]; i < end;) {
      const std::size_t start = i++;
      while (i < end && run_of(i) == run_of(start)) ++i;
      if (i - start > 1)
        std::sort(keys.begin() + static_cast<std::ptrdiff_t>(start),
                  keys.begin() + static_cast<std::ptrdiff_t>(i), before);
    }
  });
}

// The upper half of the bits tells most points of a surface apart. Where it does not, as in clumps
// far from each other, the whole code is sorted by.
void sort_keys(std::vector<CodeKey>& keys, const Shifted& cloud, const Job& job) {
  constexpr int digits = 3 * bits_per_axis / radix_digit_bits + 1, upper_digits = digits / 2;
  constexpr int lowest = 3 * bits_per_axis - upper_digits * radix_digit_bits;
  radix_sort(keys, lowest, upper_digits, job);
  const std::size_t alike = parallel_count(job, keys.size(), grain, [&](std::size_t i) {
    return i > 0 && keys[i].code >> lowest == keys[i - 1].code >> lowest;
  });
  const bool enough = alike <= keys.size() / 2;
  if (!enough) radix_sort(keys, 0, digits, job);
  sort_runs(keys, cloud, enough ? lowest : 0, job);
}

std::vector<CodeKey> sorted_keys(const Shifted& cloud, const Box& box, const Job& job) {
  const Curve curve(box);
  const std::span<const Vec3> points = cloud.points;
  std::vector<CodeKey> keys = parallel_collect<CodeKey>(
      job, points.size(), grain, [&](std::size_t begin, std::size_t end, auto& found) {
        found.reserve(end - begin);
        for (std::size_t i = begin; i < end; ++i)
          if (is_finite(points[i]))
            found.push_back({curve.code(points[i]), static_cast<std::uint32_t>(i)});
      });
  sort_keys(keys, cloud, job);
  return keys;
}

// Writes the places the keys name, repeated ones once.
void place_points(const Shifted& shifted, std::span<const CodeKey> keys, OrderedCloud& cloud,
                  const Job& job) {
  const auto is_new = [&](std::size_t i) {
    return i == 0 || keys[i].code != keys[i - 1].code ||
           !(shifted.at(keys[i]) == shifted.at(keys[i - 1]));
  };
  std::vector<std::size_t> first((keys.size() + grain - 1) / grain);  // place of each range's first
  parallel_for(job, "", keys.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) first[begin / grain] += is_new(i);
  });
  std::size_t places = 0;
  for (std::size_t& f : first) places += std::exchange(f, places);
  cloud.points.resize(places);
  cloud.codes.resize(places);
  parallel_for(job, "order", keys.size(), grain, [&](std::size_t begin, std::size_t end) {
    std::size_t place = first[begin / grain];
    for (std::size_t i = begin; i < end; ++i) {
      if (is_new(i)) {
        cloud.points[place] = shifted.at(keys[i]);
        cloud.codes[place++] = keys[i].code;
      }
      cloud.rank[keys[i].index] = static_cast<std::uint32_t>(place - 1);
    }
  });
}

void check_size(const Box& box) {
  const double size = largest_side(box);
  if (size == 0 || (size >= smallest_size && size <= largest_size)) return;
  throw NoResultError("the cloud is " + std::string(size < 1 ? "less than 1e-70" : "over 1e70") +
                      " across, which cannot be computed with; give it in another unit");
}

}  // namespace

OrderedCloud order_cloud(std::span<const Vec3> points, const Job& job) {
  if (points.size() >= no_point)
    throw UsageError(
        "a cloud of " + std::to_string(points.size()) +
        " points is beyond the 4 294 967 294 that one run can hold; cut it into tiles");
  OrderedCloud cloud;
  const Box box = finite_box(points, job);
  check_size(box);
  cloud.origin = box.empty() ? Vec3{} : box.center();
  cloud.rank.assign(points.size(), no_point);
  const Shifted shifted{points, cloud.origin};
  const std::vector<CodeKey> keys = sorted_keys(shifted, box, job);
  place_points(shifted, keys, cloud, job);
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
