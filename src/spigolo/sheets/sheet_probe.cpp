// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/sheet_probe.cpp
#include "spigolo/sheets/sheet_probe.h"

#include <algorithm>
#include <cmath>

#include "spigolo/sheets/label_hints.h"

namespace spigolo {
namespace {

constexpr int narrowings = 3;
constexpr std::size_t most_known = 1024;  // places kept; neighbors in order share them
constexpr double slack_share = 0.08;      // of h

}  // namespace

ProbeReach probe_reach(double noise) {
  const double h = std::clamp(1.3 + 12 * noise, 1.3, 6.0);
  return {h, points_for(h)};
}

std::size_t points_for(double smoothing) {
  return std::max<std::size_t>(32, static_cast<std::size_t>(9 * smoothing * smoothing) + 12);
}

SheetProbe::SheetProbe(const SheetModel& model, const KdTree& tree, const ProbeReach& reach)
    : model_(model), tree_(tree), reach_(reach), wide_(reach_of_places(reach)), separator_(model) {}

const LocalSheets& SheetProbe::look(const Vec3& center) {
  if (model_.places.empty()) {
    const std::uint32_t nearest = place_at(center);
    gather_region(model_, tree_, center, reach_, region_);
    seek(!model_.plain.empty() && model_.plain[nearest]);
    away_ = std::sqrt(nearest_.front().squared_distance);
    spacing_ = region_.spacing, slack_ = 0, place_ = nearest;
    return region_.sheets;
  }
  place_ = place_at(center);
  away_ = std::sqrt(nearest_.front().squared_distance);
  const PartedRegion& region = region_of(place_);
  spacing_ = region.spacing;
  slack_ = slack_share * region.smoothing;
  fit_around(region, center, fit_ridge(model_.tolerances.noise), weights_, fitted_);
  return fitted_;
}

const LocalSheets& SheetProbe::look_at(std::uint32_t point,
                                       std::span<const std::uint32_t> neighbors) {
  gather_region(model_, point, neighbors, reach_.smoothing, region_);
  seek(!model_.plain.empty() && model_.plain[point]);
  away_ = 0, spacing_ = region_.spacing, slack_ = 0, place_ = point;
  return region_.sheets;
}

std::uint32_t SheetProbe::place_at(const Vec3& x) {
  tree_.nearest(x, 1, nearest_);
  const std::uint32_t nearest = nearest_.front().index;
  return model_.places.empty() ? nearest : model_.places.of_point[nearest];
}

const PartedRegion& SheetProbe::region_of(std::uint32_t place) {
  if (const auto known = known_.find(place); known != known_.end()) return known->second;
  if (known_.size() >= most_known) known_.clear();
  const SheetPlaces& places = model_.places;
  const std::uint32_t entry = places.known[place];
  if (entry == no_point) {
    gather_region(model_, tree_, model_.points()[places.point[place]], wide_, region_);
    separator_.take_one(region_);
  } else {
    gather_region(model_, tree_, model_.points()[places.point[place]], places.sheets[entry].reach,
                  region_);
    region_.sheets = places.sheets[entry].sheets;
    separator_.label(region_);
  }
  const std::vector<CreasePin> pins = pin_creases(model_, region_, model_.places.noise);
  return known_.emplace(place, part(region_, model_.places.noise, pins)).first->second;
}

// With noise a wide look may be too much for one quadric a sheet; then with half the points again.
void SheetProbe::seek(bool plain) {
  for (int narrowed = 0;; ++narrowed) {
    if (plain)
      separator_.take_one(region_);
    else
      separator_.separate(region_);
    if (narrowed == narrowings || !separator_.fits_badly(region_.sheets) || !halve(region_)) break;
  }
}

}  // namespace spigolo
