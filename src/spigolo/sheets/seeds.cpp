// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/seeds.cpp
#include "spigolo/sheets/seeds.h"

#include <algorithm>
#include <cmath>

#include "spigolo/sheets/heights.h"

namespace spigolo {
namespace {

constexpr double exact_noise = 0.02;  // [spacings] with less, fits are as exact as the data
constexpr double on_floor = 0.08, on_growth = 0.02, wide = 1.9;  // of a seed's reach
constexpr std::size_t exact_seeds = 5,
                      most_seeds = 16;  // own sheets that are tried for each further sheet
constexpr std::size_t least_gain = 2, gain_share = 24;  // points, share of all
constexpr std::size_t most_sampled = 96;                // points that a sheet is tried on, or so
constexpr std::size_t at_once = 16;                     // of them, before looking whether to go on
constexpr double rounding = 1e-6;                       // points

bool same_fit(const Sheet& a, const Sheet& b) {
  return a.origin == b.origin && a.deviation == b.deviation && a.a == b.a && a.n == b.n;
}

}  // namespace

// A quadric fitted to fewer points is trusted less the farther it reaches.
SheetSeeder::SheetSeeder(const SheetModel& model)
    : model_(model),
      trust_{std::max(on_floor, wide * model.tolerances.noise), on_growth,
             std::sqrt(static_cast<double>(model.tolerances.k) / pi), 1} {}

// How many points of the sample the sheet explains; some lower number as soon as it is plain that
// it is less than `least`.
double SheetSeeder::gain_of(const Sheet& sheet, double least) {
  const std::span<const Vec3> sample = sample_;
  explained_.resize(sample.size());
  double gain = 0;
  for (std::size_t begin = 0; begin < sample.size(); begin += at_once) {
    const std::size_t n = std::min(at_once, sample.size() - begin);
    explained(sheet, sample.subspan(begin, n), trust_, &explained_[begin]);
    for (std::size_t o = begin; o < begin + n; ++o) gain += explained_[o];
    if (gain + static_cast<double>(sample.size() - begin - n) < least - rounding) break;
  }
  return gain;
}

// The own sheet of an unlabelled point that explains most of the sample; null: none is worth it.
const Sheet* SheetSeeder::find_next(const SheetRegion& region) {
  const std::size_t n = region.points.size(), stride = std::max<std::size_t>(1, n / most_sampled);
  const double asked = static_cast<double>(std::max(least_gain, n / gain_share));
  const double least = asked / static_cast<double>(stride);
  sample_.clear(), tried_.clear();
  std::size_t left = 0, seen = 0;
  for (std::size_t t = 0; t < n; ++t) {
    if (region.label[t] >= 0) continue;
    ++left;
    if (t % stride == 0) sample_.push_back(region.points[t]);
  }
  const std::size_t seeds = model_.tolerances.noise < exact_noise ? exact_seeds : most_seeds;
  const std::size_t step = std::max<std::size_t>(1, left / seeds);
  double best_gain = 0;
  const Sheet* best = nullptr;
  for (std::size_t t = 0; t < n; ++t) {
    if (region.label[t] >= 0 || seen++ % step != 0) continue;
    const Sheet& sheet = model_.own[region.found[t].index];
    const auto same = [&](const Sheet* other) { return same_fit(sheet, *other); };
    if (!sheet.fitted() || std::any_of(tried_.begin(), tried_.end(), same)) continue;
    tried_.push_back(&sheet);
    const double gain = gain_of(sheet, std::max(best_gain, least));
    if (gain > best_gain) best_gain = gain, best = &sheet;
  }
  return best_gain * static_cast<double>(stride) < asked ? nullptr : best;
}

void SheetSeeder::seed(SheetRegion& region) {
  const std::size_t n = region.points.size();
  trust_.spacing = region.spacing;
  region.label.assign(n, -1);
  region.sheets.count = 0;
  region.sheets.data_sides.fill(~std::uint64_t{0});
  while (region.sheets.count < LocalSheets::most) {
    const Sheet* best = find_next(region);
    if (!best) break;
    explained_.resize(n);
    explained(*best, region.points, trust_, explained_.data());
    for (std::size_t t = 0; t < n; ++t)
      if (region.label[t] < 0 && explained_[t] > 0)
        region.label[t] = static_cast<std::int8_t>(region.sheets.count);
    region.sheets.sheet[region.sheets.count++] = *best;
  }
}

}  // namespace spigolo
