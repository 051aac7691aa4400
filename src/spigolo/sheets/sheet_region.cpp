// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/sheet_region.cpp
#include "spigolo/sheets/sheet_region.h"

#include <algorithm>
#include <cmath>

#include "spigolo/sheets/normal_equations.h"
#include "spigolo/sheets/shares.h"

namespace spigolo {
namespace {

constexpr double support = 1.85;      // R in h: so the compact weight counts about as many points
constexpr double least_share = 0.02;  // smaller ones are left out
constexpr double least_support =
    1.2;                              // [h] the query is at the rim of the region, which is far off
constexpr double flat_ridge = 1e-12;  // share of the weight: points on a line leave the tilt open

// Memory of the weights of one sheet's points; how many count, or too few.
int weigh(std::span<const Vec3> points, std::span<const double> share, const Vec3& query,
          double reach2, std::vector<double>& w) {
  w.resize(points.size());
  double nearest = infinity;
  for (std::size_t i = 0; i < points.size(); ++i) {
    w[i] = squared_distance(points[i], query);
    nearest = std::min(nearest, w[i]);
  }
  if (nearest > reach2) return 0;
  const double scale = 1 / (reach2 + nearest);
  int count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double t = std::max(0.0, 1 - (w[i] - nearest) * scale);
    w[i] = share[i] * (t * t * t);
    count += t > 0;
  }
  return count;
}

}  // namespace

void gather_region(const SheetModel& model, const KdTree& tree, const Vec3& center,
                   const ProbeReach& reach, SheetRegion& region) {
  region.center = center;
  region.smoothing = reach.smoothing;
  tree.nearest(center, reach.k, region.found);
  region.points.clear();
  double spacings = 0;  // the nearest point's alone scatters, and with it how far a look weighs
  for (const Neighbor& n : region.found) {
    region.points.push_back(model.points()[n.index]);
    spacings += model.prepared.spacing.of_point[n.index];
  }
  region.spacing = spacings / static_cast<double>(region.found.size());
}

void gather_region(const SheetModel& model, std::uint32_t point,
                   std::span<const std::uint32_t> neighbors, double smoothing,
                   SheetRegion& region) {
  region.center = model.points()[point];
  region.smoothing = smoothing;
  region.spacing = model.prepared.spacing.of_point[point];
  region.found.assign(1, {0, point});
  region.points.assign(1, region.center);
  for (const std::uint32_t j : neighbors) {
    region.points.push_back(model.points()[j]);
    region.found.push_back({squared_distance(region.points.back(), region.center), j});
  }
}

PartedRegion part(const SheetRegion& region, double noise, std::span<const CreasePin> pins) {
  PartedRegion r{region.center, region.spacing, region.smoothing, 0, {}, {}, {}, region.sheets};
  r.radius = std::sqrt(region.found.back().squared_distance);
  std::vector<std::array<double, LocalSheets::most>> shares(region.points.size());
  const bool mixed = noise > 0 && region.sheets.count > 1;
  for (std::size_t t = 0; t < shares.size(); ++t)
    if (mixed)
      shares[t] = shares_of(region.sheets, region.points[t], noise);
    else if (region.label[t] >= 0)
      shares[t][static_cast<std::size_t>(region.label[t])] = 1;
  for (std::size_t s = 0; s < region.sheets.count; ++s) {
    for (std::size_t t = 0; t < shares.size(); ++t) {
      if (shares[t][s] < least_share) continue;
      r.points.push_back(region.points[t]);
      r.share.push_back(shares[t][s]);
    }
    for (const CreasePin& pin : pins) {
      if (pin.sheets[0] != s && pin.sheets[1] != s) continue;
      r.points.push_back(pin.place);
      r.share.push_back(pin.weight);
    }
    r.begin[s + 1] = static_cast<std::uint32_t>(r.points.size());
  }
  return r;
}

void fit_around(const PartedRegion& region, const Vec3& query, double ridge,
                std::vector<double>& weights, LocalSheets& fitted) {
  fitted = region.sheets;
  const double off = distance(query, region.center);
  const double h = region.smoothing * region.spacing;
  const double reach = std::max(least_support * h, std::min(support * h, region.radius - off));
  for (std::size_t s = 0; s < fitted.count; ++s) {
    const std::span<const Vec3> points{region.points.data() + region.begin[s],
                                       region.begin[s + 1] - region.begin[s]};
    const std::span<const double> share{region.share.data() + region.begin[s], points.size()};
    const bool curved = region.sheets.sheet[s].is_curved();
    if (weigh(points, share, query, reach * reach, weights) < (curved ? quadric_points : 3))
      continue;
    Sheet sheet = region.sheets.sheet[s];
    sheet.n = normal_at(sheet, query);
    sheet.u = any_perpendicular(sheet.n);
    sheet.v = cross(sheet.n, sheet.u);
    sheet.origin = query;
    if (curved ? solve_quadric(points, weights, ridge, sheet)
               : solve_plane(points, weights, flat_ridge, sheet))
      fitted.sheet[s] = sheet;
  }
}

}  // namespace spigolo
