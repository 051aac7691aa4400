// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/local_sheets.cpp
#include "spigolo/sheets/local_sheets.h"

#include <bit>
#include <cmath>

namespace spigolo {
namespace {

constexpr int foot_steps = 24;
constexpr double converged = 1e-11;  // [spacings]
constexpr double settled = 1e-4;   // [spacings] the last step of an iteration that is near its end
constexpr double undecided = 0.2;  // of a half: a sheet so evenly on both sides ends at neither
constexpr double farthest = 4;     // [spacings]

// Bits of the sheets above which x lies, and of those that it is too close to to say.
struct Sides {
  std::uint32_t above = 0, open = 0;
};

Sides sides_of(const LocalSheets& sheets, const Vec3& x, std::uint32_t free) {
  Sides sides;
  for (std::size_t c = 0; c < sheets.count; ++c) {
    const std::uint32_t bit = 1U << c;
    if (free & bit) {
      sides.open |= bit;
      continue;
    }
    const double h = height(sheets.sheet[c], x);
    if (h > 0) sides.above |= bit;
    if (std::abs(h) <= sheets.tolerance) sides.open |= bit;
  }
  return sides;
}

class Nearest {
 public:
  explicit Nearest(const Vec3& query) : query_(query) {}

  void offer(FootKind kind, const Vec3& at, std::array<std::uint8_t, 3> sheets) {
    const double away = squared_distance(at, query_);
    if (away >= best_) return;
    best_ = away;
    foot_ = {kind, at, sheets};
  }
  const Foot& foot() const { return foot_; }

 private:
  Vec3 query_;
  double best_ = infinity;
  Foot foot_;
};

std::uint8_t name(std::size_t s) { return static_cast<std::uint8_t>(s); }

void offer_creases(const LocalSheets& sheets, const Vec3& query, Nearest& nearest) {
  for (std::size_t a = 0; a < sheets.count; ++a) {
    for (std::size_t b = a + 1; b < sheets.count; ++b) {
      const auto crease = find_crease(sheets.sheet[a], sheets.sheet[b], query);
      if (!crease) continue;
      const std::uint32_t both = (1U << a) | (1U << b);
      if (sheets.is_surface(a, crease->point, both) && sheets.is_surface(b, crease->point, both))
        nearest.offer(FootKind::crease, crease->point, {name(a), name(b), 0});
    }
  }
}

void offer_corners(const LocalSheets& sheets, const Vec3& query, Nearest& nearest) {
  for (std::size_t a = 0; a < sheets.count; ++a)
    for (std::size_t b = a + 1; b < sheets.count; ++b)
      for (std::size_t c = b + 1; c < sheets.count; ++c) {
        const auto corner =
            find_corner({&sheets.sheet[a], &sheets.sheet[b], &sheets.sheet[c]}, query);
        if (!corner) continue;
        const std::uint32_t all = (1U << a) | (1U << b) | (1U << c);
        if (sheets.is_surface(a, *corner, all) && sheets.is_surface(b, *corner, all) &&
            sheets.is_surface(c, *corner, all))
          nearest.offer(FootKind::corner, *corner, {name(a), name(b), name(c)});
      }
}

}  // namespace

bool LocalSheets::is_surface(std::size_t s, const Vec3& x, std::uint32_t free) const {
  if (count == 1) return true;
  const Sides sides = sides_of(*this, x, free | 1U << s);
  return has_data(s, sides.above, sides.open);
}

bool LocalSheets::has_data(std::size_t s, std::uint32_t above, std::uint32_t open) const {
  const std::uint32_t fixed = ~(open | 1U << s) & ((1U << count) - 1);
  std::uint64_t seen = data_sides[s];
  if (count < most) seen &= (std::uint64_t{1} << (1U << count)) - 1;
  for (; seen != 0; seen &= seen - 1)
    if (((static_cast<std::uint32_t>(std::countr_zero(seen)) ^ above) & fixed) == 0) return true;
  return false;
}

std::optional<Vec3> find_foot(const Sheet& sheet, const Vec3& query) {
  Vec3 x = query;
  double step = infinity;
  for (int i = 0; i < foot_steps && step > converged * sheet.spacing; ++i) {
    const Vec3 n = normal_at(sheet, x), off = query - x;
    const Vec3 move = off - n * dot(off, n) - n * (height(sheet, x) * sheet.spacing);
    x += move;
    step = norm(move);
    if (squared_distance(x, sheet.origin) > farthest * farthest * sheet.spacing * sheet.spacing)
      return std::nullopt;
  }
  if (!(step <= settled * sheet.spacing)) return std::nullopt;
  return x;
}

Foot find_nearest_sheet(const LocalSheets& sheets, const Vec3& query) {
  Nearest nearest(query);
  for (std::size_t s = 0; s < sheets.count; ++s)
    if (const auto foot = find_foot(sheets.sheet[s], query))
      nearest.offer(FootKind::sheet, *foot, {name(s), 0, 0});
  return nearest.foot();
}

Foot find_nearest_foot(const LocalSheets& sheets, const Vec3& query) {
  if (sheets.count == 1) return find_nearest_sheet(sheets, query);
  Nearest nearest(query);
  for (std::size_t s = 0; s < sheets.count; ++s) {
    const auto foot = find_foot(sheets.sheet[s], query);
    if (foot && sheets.is_surface(s, *foot)) nearest.offer(FootKind::sheet, *foot, {name(s), 0, 0});
  }
  offer_creases(sheets, query, nearest);
  offer_corners(sheets, query, nearest);
  return nearest.foot().kind == FootKind::none ? find_nearest_sheet(sheets, query) : nearest.foot();
}

namespace {

// From the crease into the part of sheet s that is surface: square to the crease, in the sheet.
std::optional<Vec3> into_sheet(const LocalSheets& sheets, std::size_t s, std::size_t other,
                               const Crease& crease, const Vec3& normal) {
  const Vec3 side = cross(normal, crease.direction);
  const double h = dot(normal_at(sheets.sheet[other], crease.point), side);
  const double share = static_cast<double>(sheets.share_above[s][other]);
  if (std::abs(share - 0.5) < undecided) return std::nullopt;
  return (h > 0) == (share > 0.5) ? side : -side;
}

std::optional<Vec3> corner_on(const LocalSheets& sheets, std::size_t a, std::size_t b,
                              const Vec3& query) {
  Nearest nearest(query);
  for (std::size_t c = 0; c < sheets.count; ++c) {
    if (c == a || c == b) continue;
    const auto corner = find_corner({&sheets.sheet[a], &sheets.sheet[b], &sheets.sheet[c]}, query);
    const std::uint32_t all = (1U << a) | (1U << b) | (1U << c);
    if (corner && sheets.is_surface(a, *corner, all) && sheets.is_surface(b, *corner, all) &&
        sheets.is_surface(c, *corner, all))
      nearest.offer(FootKind::corner, *corner, {name(a), name(b), name(c)});
  }
  if (nearest.foot().kind == FootKind::none) return std::nullopt;
  return nearest.foot().position;
}

}  // namespace

std::optional<CreasePlace> find_nearest_crease(const LocalSheets& sheets, const Vec3& query) {
  std::optional<CreasePlace> best;
  for (std::size_t a = 0; a < sheets.count; ++a) {
    for (std::size_t b = a + 1; b < sheets.count; ++b) {
      const auto crease = find_crease(sheets.sheet[a], sheets.sheet[b], query);
      if (!crease || (best && squared_distance(crease->point, query) >=
                                  squared_distance(best->crease.point, query)))
        continue;
      const std::uint32_t both = (1U << a) | (1U << b);
      if (!sheets.is_surface(a, crease->point, both) || !sheets.is_surface(b, crease->point, both))
        continue;
      const auto into_a = into_sheet(sheets, a, b, *crease, crease->normal[0]);
      const auto into_b = into_sheet(sheets, b, a, *crease, crease->normal[1]);
      if (!into_a || !into_b) continue;
      best = {*crease,
              {name(a), name(b)},
              {*into_a, *into_b},
              pi - angle_between(*into_a, *into_b),
              corner_on(sheets, a, b, query)};
    }
  }
  return best;
}

}  // namespace spigolo
