// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/joints.cpp
#include "spigolo/sheets/joints.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "spigolo/core/parallel.h"
#include "spigolo/core/symmetric3.h"

namespace spigolo {
namespace {

constexpr std::size_t grain = 1024;
constexpr std::size_t asked = 48;                      // neighbors whose creases may run in
constexpr double spread = 0.9;                         // [spacings] creases this close may be one
constexpr double parallel = 0.9;                       // cosine of directions that are one crease
constexpr std::size_t least_points = 3;                // of a crease
constexpr std::size_t least_creases = 3;               // of a corner
constexpr double common = 0.7;                         // [spacings] of a crease from the corner
constexpr double edge_reach = 0.9, other_reach = 0.6;  // [spacings] of the point from it
constexpr double least_spread = 0.02;  // smallest eigenvalue of the directions' scatter, share

struct Strand {
  Vec3 point, direction;  // mean of some points' creases, beside the place looked from
  std::size_t points = 0;
  double deviation = 0;
};

bool is_edge(const SheetVerdict& v) { return v.kind == PointKind::edge; }

// The creases of the neighbors and the point itself, drawn out to beside the point.
std::vector<Strand> gather(std::span<const Vec3> points, std::span<const std::uint32_t> row,
                           const VerdictRows& verdicts, std::uint32_t i) {
  std::vector<Strand> strands;
  const auto hear = [&](std::uint32_t j) {
    const SheetVerdict& v = verdicts[j];
    if (!is_edge(v)) return;
    const Vec3 foot = v.crease_point + v.direction * dot(points[i] - v.crease_point, v.direction);
    strands.push_back({foot, v.direction, 1, v.deviation});
  };
  hear(i);
  for (const std::uint32_t j : row.first(std::min(asked, row.size()))) hear(j);
  return strands;
}

bool alike(const Strand& a, const Strand& b) {
  return std::abs(dot(a.direction, b.direction)) > parallel;
}

Strand mean_of(std::span<const Strand> strands) {
  Strand mean;
  const double n = static_cast<double>(strands.size());
  for (const Strand& s : strands) {
    mean.point += s.point / n;
    mean.direction += dot(s.direction, strands.front().direction) < 0 ? -s.direction : s.direction;
    mean.deviation += s.deviation / n;
  }
  mean.direction = normalized(mean.direction);
  mean.points = strands.size();
  return mean;
}

// The creases that these are pieces of, one a direction: the strongest first.
std::vector<Strand> bundle(std::vector<Strand> pieces, double spacing) {
  std::vector<Strand> creases;
  while (pieces.size() >= least_points) {
    std::vector<Strand> best;
    for (const Strand& center : pieces) {
      std::vector<Strand> group;
      for (const Strand& s : pieces)
        if (alike(s, center) && distance(s.point, center.point) < spread * spacing)
          group.push_back(s);
      if (group.size() > best.size()) best = std::move(group);
    }
    if (best.size() < least_points) break;
    creases.push_back(mean_of(best));
    std::erase_if(pieces, [&](const Strand& s) { return alike(s, creases.back()); });
  }
  return creases;
}

double away_from(const Strand& s, const Vec3& x) {
  const Vec3 d = x - s.point;
  return norm(d - s.direction * dot(d, s.direction));
}

// Nearest to all creases in least squares, by the points they stand for.
std::optional<Vec3> common_point(std::span<const Strand> creases, const Vec3& from) {
  Symmetric3 m, directions;
  Vec3 b;
  for (const Strand& s : creases) {
    const auto weight = static_cast<double>(s.points);
    const Vec3 u = any_perpendicular(s.direction), v = cross(s.direction, u);
    for (const Vec3& axis : {u, v}) {
      m.add(axis * std::sqrt(weight));
      b += axis * (weight * dot(s.point - from, axis));
    }
    directions.add(s.direction);
  }
  if (smallest_axis(directions).value < least_spread * static_cast<double>(creases.size()))
    return std::nullopt;
  const Vec3 c0{m.xx, m.xy, m.xz}, c1{m.xy, m.yy, m.yz}, c2{m.xz, m.yz, m.zz};
  const double determinant = dot(c0, cross(c1, c2));
  return from +
         Vec3{dot(b, cross(c1, c2)), dot(c0, cross(b, c2)), dot(c0, cross(c1, b))} / determinant;
}

std::optional<SheetVerdict> joint_at(std::span<const Vec3> points,
                                     std::span<const std::uint32_t> row,
                                     const VerdictRows& verdicts, std::uint32_t i, double spacing) {
  std::vector<Strand> creases = bundle(gather(points, row, verdicts, i), spacing);
  std::optional<Vec3> x;
  // Creases that only pass by draw the common point away; they go one by one.
  while (creases.size() >= least_creases) {
    x = common_point(creases, points[i]);
    if (!x) return std::nullopt;
    const auto worst = std::max_element(
        creases.begin(), creases.end(),
        [&](const Strand& a, const Strand& b) { return away_from(a, *x) < away_from(b, *x); });
    if (away_from(*worst, *x) <= common * spacing) break;
    creases.erase(worst);
  }
  const double reach = is_edge(verdicts[i]) ? edge_reach : other_reach;
  if (creases.size() < least_creases || distance(*x, points[i]) > reach * spacing)
    return std::nullopt;
  SheetVerdict found;
  found.kind = PointKind::corner;
  found.crease_point = *x;
  found.sheets = static_cast<std::uint8_t>(creases.size());
  for (const Strand& s : creases) found.deviation = std::max(found.deviation, s.deviation);
  return found;
}

}  // namespace

void join_creases(std::span<const Vec3> points, const Neighborhoods& neighborhoods,
                  const Spacing& spacing, VerdictRows& verdicts, const Job& job) {
  verdicts.set(parallel_collect<FoundVerdict>(
      job, points.size(), grain, [&](std::size_t begin, std::size_t end, auto& here) {
        for (std::size_t i = begin; i < end; ++i) {
          if (verdicts[i].kind != PointKind::edge && verdicts[i].kind != PointKind::surface)
            continue;
          if (auto joint = joint_at(points, neighborhoods.of(i), verdicts,
                                    static_cast<std::uint32_t>(i), spacing.of_point[i]))
            here.emplace_back(static_cast<std::uint32_t>(i), *joint);
        }
      }));
}

}  // namespace spigolo
