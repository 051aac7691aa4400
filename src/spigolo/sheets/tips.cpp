// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/tips.cpp
#include "spigolo/sheets/tips.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "spigolo/core/parallel.h"
#include "spigolo/core/symmetric3.h"

namespace spigolo {
namespace {

constexpr double most_noise = 0.15;                   // [spacings]
constexpr double first_reach = 2;                     // [spacings] of a first guess from its point
constexpr double tip_reach = 0.66, widest_reach = 1;  // [spacings]
constexpr double fan_reach = 5;                       // [spacings] the cone is looked at
constexpr double inner = 1;  // [spacings] fits nearer to the tip straddle it
constexpr double first_miss = 0.25, miss = 0.2,
                 miss_noise = 2;    // [spacings], [standard deviations]
constexpr double least_fan = 0.02;  // smallest eigenvalue of the normals' scatter, as a share
constexpr double twin_angle = radians(6), twin_noise = radians(60);  // [rad], per spacing of noise
constexpr double most_twins = 0.14;  // share of the others that a normal of a fan has within 6 deg
constexpr double least_bend = 0.1;   // of a cone of 150 degrees it is 0.27
constexpr std::size_t least_points = 12;
constexpr std::size_t grain = 1024;

// Meeting point of the tangent planes at these places, by least squares.
struct Meeting {
  Vec3 point;
  double miss = infinity;  // [spacings] rms distance of the planes
};

std::optional<Meeting> meet(const SheetCloud& cloud, std::span<const std::uint32_t> members,
                            double spacing) {
  Symmetric3 m;
  Vec3 b;
  const Vec3 origin = cloud.points[members[0]];
  std::size_t n = 0;
  for (const std::uint32_t j : members) {
    if (!cloud.sheets[j].fitted()) continue;
    const Vec3 normal = normal_at(cloud.sheets[j], cloud.points[j]);
    m.add(normal);
    b += normal * dot(normal, cloud.points[j] - origin);
    ++n;
  }
  if (n < least_points || smallest_axis(m).value < least_fan * static_cast<double>(n))
    return std::nullopt;
  const Vec3 c0{m.xx, m.xy, m.xz}, c1{m.xy, m.yy, m.yz}, c2{m.xz, m.yz, m.zz};
  const double determinant = dot(c0, cross(c1, c2));
  const Vec3 x{dot(b, cross(c1, c2)) / determinant, dot(c0, cross(b, c2)) / determinant,
               dot(c0, cross(c1, b)) / determinant};
  double squares = 0;
  for (const std::uint32_t j : members) {
    if (!cloud.sheets[j].fitted()) continue;
    const Vec3 normal = normal_at(cloud.sheets[j], cloud.points[j]);
    const double off = dot(normal, origin + x - cloud.points[j]) / spacing;
    squares += off * off;
  }
  return Meeting{origin + x, std::sqrt(squares / static_cast<double>(n))};
}

// Whether the surface around bends as a cone does: its curvature times the distance to the apex is
// the same all along, and far from none. Facets of a pyramid are flat.
bool bends(const SheetCloud& cloud, std::span<const std::uint32_t> members, const Vec3& apex) {
  std::vector<double> bend;
  for (const std::uint32_t j : members) {
    if (!cloud.sheets[j].fitted()) continue;
    const auto [most, least] = curvatures_at(cloud.sheets[j], cloud.points[j]);
    bend.push_back(std::max(std::abs(most), std::abs(least)) * distance(cloud.points[j], apex));
  }
  if (bend.empty()) return false;
  const auto middle = bend.begin() + static_cast<std::ptrdiff_t>(bend.size() / 2);
  std::nth_element(bend.begin(), middle, bend.end());
  return *middle > least_bend;
}

// Mean share of the other normals that are nearly the same as one of them.
double twins(const SheetCloud& cloud, std::span<const std::uint32_t> members, double noise) {
  std::vector<Vec3> normals;
  for (const std::uint32_t j : members)
    if (cloud.sheets[j].fitted()) normals.push_back(normal_at(cloud.sheets[j], cloud.points[j]));
  const double limit = std::cos(twin_angle + twin_noise * noise);
  std::size_t pairs = 0;
  for (std::size_t a = 0; a < normals.size(); ++a)
    for (std::size_t b = a + 1; b < normals.size(); ++b)
      pairs += std::abs(dot(normals[a], normals[b])) > limit;
  const double n = static_cast<double>(normals.size());
  return n < 2 ? 1 : 2 * static_cast<double>(pairs) / (n * (n - 1));
}

struct Tip {
  Vec3 point;
  double deviation = 0;               // [rad]
  std::vector<std::uint32_t> around;  // the cone near it
};

std::optional<Tip> find_tip(const SheetCloud& cloud, std::uint32_t i,
                            const SheetTolerances& tolerances) {
  const double s = cloud.spacing.of_point[i];
  std::vector<std::uint32_t> row(1, i);
  const auto neighbors = cloud.neighborhoods.of(i);
  row.insert(row.end(), neighbors.begin(), neighbors.end());
  const auto first = meet(cloud, row, s);
  if (!first || first->miss > first_miss + miss_noise * tolerances.noise ||
      distance(first->point, cloud.points[i]) > first_reach * s)
    return std::nullopt;
  Tip tip;
  std::vector<std::uint32_t> ring;
  for (const std::uint32_t j : second_ring(cloud, i)) {
    const double away = distance(cloud.points[j], first->point) / s;
    if (away > fan_reach) continue;
    tip.around.push_back(j);
    if (away > inner) ring.push_back(j);
  }
  if (ring.size() < least_points) return std::nullopt;
  const auto second = meet(cloud, ring, s);
  if (!second || second->miss > miss + miss_noise * tolerances.noise ||
      distance(second->point, cloud.points[i]) > first_reach * s ||
      twins(cloud, ring, tolerances.noise) > most_twins || !bends(cloud, ring, second->point))
    return std::nullopt;
  tip.point = second->point;
  Vec3 axis;
  for (const std::uint32_t j : ring) axis += normalized(cloud.points[j] - tip.point);
  axis = normalized(axis);
  double opening = 0;  // half of it
  for (const std::uint32_t j : ring)
    opening += angle_between(axis, cloud.points[j] - tip.point) / static_cast<double>(ring.size());
  tip.deviation = std::max(0.0, pi - 2 * opening);
  return tip;
}

// What the cone's own curvature feigned: creases that run into the tip.
bool feigned(const SheetVerdict& verdict, const Tip& tip, double spacing) {
  if (verdict.kind == PointKind::corner) return true;
  if (verdict.kind != PointKind::edge) return false;
  const Vec3 off = tip.point - verdict.crease_point;
  return norm(off - verdict.direction * dot(off, verdict.direction)) < spacing ||
         norm(off) < 2 * spacing;
}

// All tips, found anew from every point that may be near one, the first one of each place.
std::vector<Tip> distinct_tips(const SheetCloud& cloud, const SheetTolerances& tolerances,
                               const Job& job) {
  struct Found {
    std::uint32_t from;
    Tip tip;
  };
  const auto found = parallel_collect<Found>(job, cloud.size(), grain,
                                             [&](std::size_t begin, std::size_t end, auto& here) {
                                               for (std::size_t i = begin; i < end; ++i) {
                                                 if (cloud.sheets[i].whole) continue;
                                                 const auto from = static_cast<std::uint32_t>(i);
                                                 if (auto tip = find_tip(cloud, from, tolerances))
                                                   here.push_back({from, std::move(*tip)});
                                               }
                                             });
  std::vector<Tip> tips;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (i % grain == 0) job.check();
    const Found& f = found[i];
    const double s = cloud.spacing.of_point[f.from];
    const bool known = std::any_of(tips.begin(), tips.end(), [&](const Tip& tip) {
      return distance(tip.point, cloud.points[f.from]) < 2 * first_reach * s;
    });
    if (!known) tips.push_back(f.tip);
  }
  return tips;
}

}  // namespace

void find_tips(const SheetCloud& cloud, const SheetTolerances& tolerances, VerdictRows& verdicts,
               const Job& job) {
  if (tolerances.noise > most_noise) return;
  const std::vector<Tip> tips = distinct_tips(cloud, tolerances, job);
  for (const Tip& tip : tips) {
    const std::uint32_t nearest =
        *std::min_element(tip.around.begin(), tip.around.end(), [&](auto a, auto b) {
          return squared_distance(cloud.points[a], tip.point) <
                 squared_distance(cloud.points[b], tip.point);
        });
    for (const std::uint32_t j : tip.around) {
      const double s = cloud.spacing.of_point[j], away = distance(cloud.points[j], tip.point) / s;
      if (feigned(verdicts[j], tip, s)) verdicts.set(j, {});
      if (away < tip_reach || (j == nearest && away < widest_reach)) {
        verdicts.set(j,
                     {PointKind::tip, tip.deviation, 0.5 + 0.5 * (1 - away), tip.point, {}, {}, 1});
      }
    }
  }
}

}  // namespace spigolo
