// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/sheet_links.cpp
#include "spigolo/sheets/sheet_links.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "spigolo/core/parallel.h"

namespace spigolo {
namespace {

constexpr std::size_t linked = 8;                     // neighbors each point is linked to
constexpr double nearly_equal = 0.999, alike = 0.98;  // cosines
constexpr int classes = 3;
constexpr std::size_t grain = 1024;
constexpr std::uint32_t block = 1 << 15;  // points joined by one thread: some grains
constexpr std::size_t rim = 12;           // neighbors that the spacing of a point is measured by

// One byte a neighbor: 0 none, else 1 + 2 * class + whether the normals look to opposite sides.
struct LinkBytes {
  std::size_t k;
  std::vector<std::uint8_t> byte;
  // Of each grain of points: bit c: there are links of class c; bit `out`: some leave the block.
  // Most clouds have few of the weaker classes, and few leave: the rest need not be looked through.
  std::vector<std::uint8_t> kinds;
  static constexpr int out = classes;

  static bool differ(std::uint8_t b) { return (b - 1) & 1; }
  static int class_of(std::uint8_t b) { return (b - 1) / 2; }
};

// No neighbor that a sheet was fitted to is farther from it than this.
double farthest_fitted(const Sheet& s) {
  return s.deviation * std::sqrt(static_cast<double>(s.support));
}

// Whether all points the sheet of i was fitted to are close to it: all its neighbors.
bool fits_closely(const SheetCloud& cloud, std::size_t i, double near) {
  return cloud.sheets[i].whole && farthest_fitted(cloud.sheets[i]) <= near;
}

// The square of a distance within which all points are neighbors, by the formula of
// estimate_spacing.
double surely_neighbors2(const SheetCloud& cloud, std::size_t i) {
  const auto k = static_cast<double>(std::min(rim, cloud.neighborhoods.k));
  return cloud.spacing.of_point[i] * cloud.spacing.of_point[i] * (k + 0.5) / pi * (1 - 1e-9);
}

bool is_near(const SheetCloud& cloud, std::size_t sheet, std::size_t point, double near) {
  return std::abs(height(cloud.sheets[sheet], cloud.points[point])) <= near;
}

LinkBytes find_links(const SheetCloud& cloud, std::span<const Vec3> normal, double near,
                     const Job& job) {
  LinkBytes links{std::min(linked, cloud.neighborhoods.k), {}, {}};
  links.byte.resize(cloud.size() * links.k);
  links.kinds.resize((cloud.size() + grain - 1) / grain);
  std::vector<char> close(cloud.size());
  parallel_for(job, "", cloud.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) close[i] = fits_closely(cloud, i, near);
  });
  const auto passes = [&](std::size_t sheet, std::size_t point, double away2) {
    return (close[sheet] && away2 < surely_neighbors2(cloud, sheet)) ||
           is_near(cloud, sheet, point, near);
  };
  parallel_for(job, "", cloud.size(), grain, [&](std::size_t begin, std::size_t end) {
    std::uint8_t kinds = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const auto row = cloud.neighborhoods.of(i);
      for (std::size_t t = 0; t < links.k; ++t) {
        const double cosine = dot(normal[i], normal[row[t]]), size = std::abs(cosine);
        if (size < one_sheet_cosine) continue;
        const double away2 = squared_distance(cloud.points[i], cloud.points[row[t]]);
        if (!passes(i, row[t], away2) || !passes(row[t], i, away2)) continue;
        const int of_class = size > nearly_equal ? 0 : size > alike ? 1 : 2;
        links.byte[i * links.k + t] = static_cast<std::uint8_t>(1 + 2 * of_class + (cosine < 0));
        const bool leaves = row[t] / block != i / block;
        kinds |= static_cast<std::uint8_t>(1 << of_class | leaves << LinkBytes::out);
      }
    }
    links.kinds[begin / grain] |= kinds;
  });
  return links;
}

// Joins over the links of one class of points [begin, end), those within the range or those that
// leave it or both. False if one contradicts what was said before.
enum class Which { inside, leaving, both };

bool join(const SheetCloud& cloud, const LinkBytes& links, int of_class, Which which,
          std::uint32_t begin, std::uint32_t end, ParitySets& sets) {
  const int asked = 1 << of_class | (which == Which::leaving ? 1 << LinkBytes::out : 0);
  bool consistent = true;
  for (std::uint32_t i = begin; i < end; ++i) {
    if ((links.kinds[i / grain] & asked) != asked) {
      i = static_cast<std::uint32_t>((i / grain + 1) * grain - 1);  // on to the next grain
      continue;
    }
    const auto row = cloud.neighborhoods.of(i);
    for (std::size_t t = 0; t < links.k; ++t) {
      const std::uint8_t link = links.byte[i * links.k + t];
      if (link == 0 || LinkBytes::class_of(link) != of_class) continue;
      const bool inside = row[t] >= begin && row[t] < end;
      if (which != Which::both && inside != (which == Which::inside)) continue;
      consistent &= sets.join(i, row[t], LinkBytes::differ(link));
    }
  }
  return consistent;
}

// The strongest links block by block, all blocks at once. As long as no link contradicts the
// others their order does not matter; false if one does.
bool join_by_blocks(const SheetCloud& cloud, const LinkBytes& links, ParitySets& sets,
                    const Job& job) {
  const auto n = static_cast<std::uint32_t>(cloud.size());
  std::vector<char> consistent((n + block - 1) / block);
  const auto in_block = [&](std::size_t b, Which which) {
    const auto begin = static_cast<std::uint32_t>(b * block);
    return join(cloud, links, 0, which, begin, std::min(n - begin, block) + begin, sets);
  };
  parallel_for(job, "", consistent.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) consistent[b] = in_block(b, Which::inside);
  });
  for (std::size_t b = 0; b < consistent.size(); ++b)
    if (!consistent[b] || !in_block(b, Which::leaving)) return false;
  return true;
}

}  // namespace

std::vector<Vec3> own_normals(const SheetCloud& cloud, const Job& job) {
  std::vector<Vec3> normal(cloud.size());
  parallel_for(job, "", cloud.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (cloud.sheets[i].fitted()) normal[i] = normal_at(cloud.sheets[i], cloud.points[i]);
  });
  return normal;
}

ParitySets link_along_sheets(const SheetCloud& cloud, std::span<const Vec3> normal, double near,
                             const Job& job) {
  const LinkBytes links = find_links(cloud, normal, near, job);
  ParitySets sets(cloud.size());
  int next_class = 1;
  if (!join_by_blocks(cloud, links, sets, job)) sets = ParitySets(cloud.size()), next_class = 0;
  for (; next_class < classes; ++next_class)
    join(cloud, links, next_class, Which::both, 0, static_cast<std::uint32_t>(cloud.size()), sets);
  return sets;
}

}  // namespace spigolo
