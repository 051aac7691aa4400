// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/rim.cpp
#include "spigolo/sheets/rim.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "spigolo/core/parallel.h"
#include "spigolo/sheets/sector.h"

namespace spigolo {
namespace {

constexpr double least_gap = radians(130);  // of directions without a point of the sheet
constexpr std::size_t least_on = 4;         // points of the sheet that show them
constexpr double sure_sheet = 0.02;         // [spacings] rms of a sheet that may end
constexpr double reach = 2;                 // [spacings] the surface goes on so close by
constexpr double lateral = 0.3;             // [spacings] beside the point, not below it
constexpr double margin = radians(20);      // of the gap's sides: neither beyond nor below
constexpr double bend_margin = radians(40), bend_slope = 0.36;  // less steep is a bend
constexpr double same_sheet = 0.1;                              // [spacings]
constexpr double thin_wall = 0.75;  // [spacings] too low for points of its own
constexpr std::size_t grain = 1024;
constexpr int least_beyond = 2;
constexpr double far_side_reach = 3, far_side_length = 1.5;  // [spacings] around, along the end

using Places = std::span<const std::uint32_t>;

// What lies off the sheet around its supposed end.
struct OffSheet {
  std::array<std::uint32_t, max_cover_points> near, outside, below;
  std::size_t near_count = 0, outside_count = 0, below_count = 0;
  bool bends = false;  // beyond the end the surface leaves the sheet only slowly

  Places nearby() const { return {near.data(), near_count}; }
  Places beyond_end() const { return {outside.data(), outside_count}; }
  Places below_sheet() const { return {below.data(), below_count}; }
};

OffSheet look_off_sheet(std::span<const Vec3> points, Places members, const SheetCover& cover,
                        const Sector& gap) {
  const Sheet& own = *cover.sheet[0];
  OffSheet off;
  for (std::size_t m = 1; m < members.size(); ++m) {
    if (cover.on[0][m]) continue;
    const Vec3 d = (points[members[m]] - points[members[0]]) / own.spacing;
    const bool near = norm(d) <= reach;
    if (near) off.near[off.near_count++] = members[m];
    const double u = dot(d, own.u), v = dot(d, own.v), beside = std::hypot(u, v);
    if (beside < lateral) continue;
    const double inside = gap.inside(std::atan2(v, u));
    if (near && inside > -bend_margin)
      off.bends |= std::abs(height(own, points[members[m]])) < bend_slope * beside;
    if (inside >= margin) off.outside[off.outside_count++] = members[m];
    if (inside < -margin) off.below[off.below_count++] = members[m];
  }
  return off;
}

bool on_any(std::span<const Vec3> points, std::span<const Sheet> sheets, Places owners,
            std::uint32_t place) {
  return std::any_of(owners.begin(), owners.end(), [&](std::uint32_t o) {
    return o == place ||
           (sheets[o].fitted() && std::abs(height(sheets[o], points[place])) < same_sheet);
  });
}

// A sheet below this one that goes on beyond the end: what ended is only the luck of the samples.
bool shows_void(std::span<const Vec3> points, std::span<const Sheet> sheets, const OffSheet& off) {
  for (const std::uint32_t o : off.beyond_end())
    for (const std::uint32_t b : off.below_sheet())
      if (sheets[o].fitted() && std::abs(height(sheets[o], points[b])) < same_sheet) return true;
  return false;
}

// The surface goes on from p: by points that are not the other side of a wall, or by a wall so low
// that it cannot have any.
bool goes_on(std::span<const Vec3> points, std::span<const Sheet> sheets, const Vec3& p,
             const OffSheet& off) {
  const Places near = off.nearby(), below = off.below_sheet();
  const bool thin = std::any_of(below.begin(), below.end(), [&](std::uint32_t b) {
    return sheets[b].fitted() && std::abs(height(sheets[b], p)) < thin_wall;
  });
  return thin || std::count_if(near.begin(), near.end(), [&](std::uint32_t o) {
                   return !on_any(points, sheets, below, o);
                 }) >= least_beyond;
}

// From the point into its sheet and on to the nearest point off it, square to the end.
std::optional<Rim> shape_rim(std::span<const Vec3> points, const Vec3& p, const Sheet& own,
                             const Sector& gap, Places near) {
  if (near.empty()) return std::nullopt;
  const double middle = gap.from + gap.width / 2;
  const Vec3 out = own.u * std::cos(middle) + own.v * std::sin(middle);
  const std::uint32_t next = *std::min_element(near.begin(), near.end(), [&](auto a, auto b) {
    return squared_distance(points[a], p) < squared_distance(points[b], p);
  });
  Rim rim;
  rim.direction = cross(own.n, out);
  const Vec3 on = points[next] - p;
  const Vec3 across = on - rim.direction * dot(on, rim.direction);
  if (!(norm(across) > 0)) return std::nullopt;
  rim.into = {-out, normalized(across)};
  rim.deviation = pi - angle_between(rim.into[0], rim.into[1]);
  return rim;
}

// Whether another sheet close by runs past the supposed end of the place's own, with points on both
// sides of it. direction: along the end; out: square to it, away from the sheet.
bool is_gap_over_far_side(const SheetCloud& cloud, std::uint32_t i, const Vec3& direction,
                          const Vec3& out) {
  const Sheet& own = cloud.sheets[i];
  const std::vector<std::uint32_t> ring = second_ring(cloud, i);
  std::vector<std::uint32_t> off;
  for (const std::uint32_t m : ring) {
    const Vec3 d = (cloud.points[m] - cloud.points[i]) / own.spacing;
    if (norm(d) < far_side_reach && std::abs(dot(d, direction)) < far_side_length &&
        std::abs(height(own, cloud.points[m])) > same_sheet)
      off.push_back(m);
  }
  return std::any_of(off.begin(), off.end(), [&](std::uint32_t o) {
    const Sheet& far = cloud.sheets[o];
    if (far.support < quadric_points || far.deviation > sure_sheet) return false;
    int beyond = 0, before = 0;
    for (const std::uint32_t m : off) {
      if (std::abs(height(far, cloud.points[m])) > same_sheet) continue;
      const double at = dot(cloud.points[m] - cloud.points[i], out) / own.spacing;
      beyond += at > lateral;
      before += at < -lateral;
    }
    return beyond >= least_beyond && before >= least_beyond;
  });
}

}  // namespace

std::optional<Rim> find_rim(std::span<const Vec3> points, std::span<const Sheet> sheets,
                            std::span<const std::uint32_t> members, const SheetCover& cover,
                            double least_deviation) {
  const Sheet& own = *cover.sheet[0];
  if (own.deviation > sure_sheet || cover.on[0].count() <= least_on) return std::nullopt;
  const Sector gap = widest_sector(points, members, own, cover.on[0]);
  if (gap.width < least_gap) return std::nullopt;
  const OffSheet off = look_off_sheet(points, members, cover, gap);
  const Vec3& p = points[members[0]];
  if (off.bends || shows_void(points, sheets, off) || !goes_on(points, sheets, p, off))
    return std::nullopt;
  const auto rim = shape_rim(points, p, own, gap, off.nearby());
  if (!rim || rim->deviation < least_deviation) return std::nullopt;
  return rim;
}

void drop_chance_rims(const SheetCloud& cloud, VerdictRows& verdicts, const Job& job) {
  const auto is_chance = [&](std::size_t i) {
    const SheetVerdict& v = verdicts[i];
    return v.kind == PointKind::edge && v.crease_point == cloud.points[i] &&
           is_gap_over_far_side(cloud, static_cast<std::uint32_t>(i), v.direction, -v.into[0]);
  };
  for (const std::uint32_t i : parallel_select(job, verdicts.size(), grain, is_chance))
    verdicts.set(i, {});
}

}  // namespace spigolo
