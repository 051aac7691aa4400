// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/sheet_probe.cpp
#include "spigolo/sheets/sheet_probe.h"

#include <algorithm>
#include <cmath>

namespace spigolo {
namespace {

constexpr double exact_noise = 0.02;  // [spacings] with less, fits are as exact as the data
constexpr double exact_ridge = 1e-5, noisy_ridge = 1e-2;
constexpr double on_floor = 0.08, on_growth = 0.02, wide = 1.9;  // of a seed's reach
constexpr double distrust = 2;  // [spacings] from a sheet: on none of them
constexpr std::size_t exact_seeds = 5,
                      most_seeds = 16;  // own sheets that are tried for each further sheet
constexpr std::size_t least_gain = 2, gain_share = 24;  // points, share of all
constexpr double plane_gain = 12;
constexpr int exact_rounds = 2, noisy_rounds = 4;
constexpr double side_floor = 1e-4, side_noise = 0.3;  // [spacings], [standard deviations]
constexpr double rare = 0.04;         // share of a noisy sheet's points that strayed over a crease
constexpr double merge_noise = 1.15;  // [standard deviations]
constexpr double merge_cosine = 0.8, merge_ratio = 20;  // of normals; of an F-test on the residuals
constexpr int narrowings = 3;
constexpr std::size_t fewest = 40;                   // points that are looked at by a narrowed look
constexpr double poor_fit = 1.5, poor_floor = 0.05;  // [standard deviations], [spacings]

}  // namespace

ProbeReach probe_reach(double noise) {
  const double h = std::clamp(1.3 + 12 * noise, 1.3, 6.0);
  return {h, points_for(h)};
}

std::size_t points_for(double smoothing) {
  return std::max<std::size_t>(32, static_cast<std::size_t>(9 * smoothing * smoothing) + 12);
}

SheetProbe::SheetProbe(const SheetModel& model, const KdTree& tree, const ProbeReach& reach)
    : model_(model), tree_(tree), reach_(reach) {}

const LocalSheets& SheetProbe::look(const Vec3& center) {
  double smoothing = reach_.smoothing;
  std::size_t k = reach_.k;
  gather(center, k);
  for (int narrowed = 0;; ++narrowed) {
    if (!model_.plain.empty() && model_.plain[found_.front().index]) {
      fit_single(center, smoothing);
    } else {
      fit_several(center, smoothing);
    }
    if (narrowed == narrowings || k / 2 < fewest || !too_wide()) break;
    k /= 2;
    smoothing /= std::sqrt(2.0);
    found_.resize(std::min(found_.size(), k));
    points_.resize(found_.size());
  }
  return sheets_;
}

void SheetProbe::gather(const Vec3& center, std::size_t k) {
  tree_.nearest(center, k, found_);
  points_.clear();
  for (const Neighbor& n : found_) points_.push_back(model_.points()[n.index]);
  spacing_ = model_.prepared.spacing.of_point[found_.front().index];
}

void SheetProbe::fit_single(const Vec3& center, double smoothing) {
  sheets_.count = 1;
  sheets_.data_sides.fill(0);
  label_.assign(points_.size(), 0);
  const std::uint32_t nearest = found_.front().index;
  sheets_.sheet[0] = model_.own[nearest];
  fit(center, smoothing);
}

void SheetProbe::fit_several(const Vec3& center, double smoothing) {
  seed();
  const int rounds = model_.tolerances.noise < exact_noise ? exact_rounds : noisy_rounds;
  for (int round = 0; round < rounds; ++round) {
    assign();
    fit(center, smoothing);
    if (model_.tolerances.noise >= exact_noise)
      while (sheets_.count > 1 && merge(center, smoothing)) fit(center, smoothing);
    if (sheets_.count < 2) break;
    note_sides();
  }
}

// Greedily from the points' own sheets: the nearest point's one first, then whichever explains most
// of what is left. A quadric fitted to fewer points is trusted less the farther it reaches.
void SheetProbe::seed() {
  const double limit = std::max(on_floor, wide * model_.tolerances.noise);
  const std::size_t seeds = model_.tolerances.noise < exact_noise ? exact_seeds : most_seeds;
  label_.assign(points_.size(), -1);
  sheets_.count = 0;
  sheets_.tolerance = std::max(side_floor, side_noise * model_.tolerances.noise);
  sheets_.data_sides.fill(~std::uint64_t{0});
  const std::size_t stride = std::max<std::size_t>(1, points_.size() / 96);
  const double known = std::sqrt(static_cast<double>(model_.tolerances.k) / pi);
  // From 1 where the sheet passes a point to 0 where it passes it by.
  const auto explains = [&](const Sheet& sheet, std::size_t t) {
    const double beyond = std::max(0.0, distance(points_[t], sheet.origin) / spacing_ - known);
    const double off = height(sheet, points_[t]) / (limit + on_growth * beyond * beyond);
    return std::max(0.0, 1 - off * off);
  };
  while (sheets_.count < LocalSheets::most) {
    std::size_t left = 0;
    for (std::size_t t = 0; t < points_.size(); ++t) left += label_[t] < 0;
    const std::size_t step = std::max<std::size_t>(1, left / seeds);
    double best_gain = 0;
    std::size_t seen = 0;
    const Sheet* best = nullptr;
    for (std::size_t t = 0; t < points_.size(); ++t) {
      if (label_[t] >= 0 || seen++ % step != 0) continue;
      const Sheet& sheet = model_.own[found_[t].index];
      if (!sheet.fitted()) continue;
      double gain = 0;
      for (std::size_t o = 0; o < points_.size(); o += stride)
        if (label_[o] < 0) gain += explains(sheet, o);
      if (gain > best_gain) best_gain = gain, best = &sheet;
    }
    const double asked = static_cast<double>(std::max(least_gain, points_.size() / gain_share));
    if (!best || best_gain * static_cast<double>(stride) < asked) break;
    for (std::size_t t = 0; t < points_.size(); ++t)
      if (label_[t] < 0 && explains(*best, t) > 0)
        label_[t] = static_cast<std::int8_t>(sheets_.count);
    sheets_.sheet[sheets_.count++] = *best;
  }
}

// Each point to the sheet whose valid part is nearest.
void SheetProbe::assign() {
  for (std::size_t t = 0; t < points_.size(); ++t) {
    double best = distrust * distrust;
    label_[t] = -1;
    std::array<double, LocalSheets::most> h{};
    for (std::size_t s = 0; s < sheets_.count; ++s) h[s] = height(sheets_.sheet[s], points_[t]);
    for (std::size_t s = 0; s < sheets_.count; ++s) {
      double cost = h[s] * h[s];
      if (cost < best && sheets_.count > 1 && !sheets_.is_surface(s, points_[t])) {
        double over = 0;
        for (std::size_t c = 0; c < sheets_.count; ++c)
          if (c != s) over = std::max(over, h[c] * h[c]);
        cost += over;
      }
      if (cost >= best) continue;
      best = cost;
      label_[t] = static_cast<std::int8_t>(s);
    }
  }
}

// One quadric to the points labelled s (or also with one of them s), the nearer to the center the
// weightier.
Sheet SheetProbe::fit_labelled(std::size_t s, std::size_t also, const Vec3& center,
                               double smoothing) {
  const bool exact = model_.tolerances.noise < exact_noise;
  const double ridge = exact ? exact_ridge : noisy_ridge;
  const auto on = [&](std::size_t t) {
    return label_[t] == static_cast<int>(s) || label_[t] == static_cast<int>(also);
  };
  weights_.resize(points_.size());
  double nearest = infinity;
  for (std::size_t t = 0; t < points_.size(); ++t)
    if (on(t)) nearest = std::min(nearest, found_[t].squared_distance);
  const double width = smoothing * smoothing * spacing_ * spacing_ + nearest;
  for (std::size_t t = 0; t < points_.size(); ++t)
    weights_[t] = on(t) ? std::exp((nearest - squared_distance(points_[t], center)) / width) : 0;
  return fit_weighted_sheet(points_, weights_, center, normal_at(sheets_.sheet[s], center),
                            spacing_, ridge, exact ? 0 : plane_gain);
}

// Joins the first two sheets that one quadric explains as well as two do; noise splits what is one.
bool SheetProbe::merge(const Vec3& center, double smoothing) {
  for (std::size_t a = 0; a < sheets_.count; ++a) {
    for (std::size_t b = a + 1; b < sheets_.count; ++b) {
      const Sheet& first = sheets_.sheet[a];
      const Sheet& second = sheets_.sheet[b];
      const double cosine = std::abs(dot(normal_at(first, center), normal_at(second, center)));
      if (cosine < merge_cosine) continue;
      const double freedom = std::max(1.0, first.support + second.support - 12.0);
      const double apart = (first.deviation * first.deviation * first.support +
                            second.deviation * second.deviation * second.support) /
                           (first.support + second.support);
      const Sheet joint = fit_labelled(a, b, center, smoothing);
      if (joint.deviation > merge_noise * model_.tolerances.noise &&
          joint.deviation * joint.deviation > (1 + merge_ratio / freedom) * apart)
        continue;
      for (std::int8_t& label : label_) {
        if (label == static_cast<int>(b)) label = static_cast<std::int8_t>(a);
        if (label > static_cast<int>(b)) --label;
      }
      sheets_.sheet[a] = joint;
      for (std::size_t c = b; c + 1 < sheets_.count; ++c) sheets_.sheet[c] = sheets_.sheet[c + 1];
      --sheets_.count;
      return true;
    }
  }
  return false;
}

void SheetProbe::fit(const Vec3& center, double smoothing) {
  std::size_t kept = 0;
  for (std::size_t s = 0; s < sheets_.count; ++s) {
    const Sheet sheet = fit_labelled(s, s, center, smoothing);
    if (!sheet.fitted()) {
      for (std::int8_t& label : label_)
        if (label == static_cast<int>(s)) label = -1;
      continue;
    }
    for (std::int8_t& label : label_)
      if (label == static_cast<int>(s)) label = static_cast<std::int8_t>(kept);
    sheets_.sheet[kept++] = sheet;
  }
  sheets_.count = kept;
}

void SheetProbe::note_sides() {
  std::array<std::array<std::uint16_t, 64>, LocalSheets::most> seen{};
  std::array<std::size_t, LocalSheets::most> total{};
  std::array<std::array<float, LocalSheets::most>, LocalSheets::most> sided{};
  sheets_.share_above = {};
  for (std::size_t t = 0; t < points_.size(); ++t) {
    if (label_[t] < 0) continue;
    const std::size_t s = static_cast<std::uint8_t>(label_[t]);
    std::uint32_t above = 0;
    bool clear = true;
    for (std::size_t c = 0; c < sheets_.count; ++c) {
      if (c == s) continue;
      const double h = height(sheets_.sheet[c], points_[t]);
      const bool on_side = std::abs(h) > sheets_.tolerance;
      clear &= on_side;
      if (h > 0) above |= 1U << c;
      if (!on_side) continue;
      sided[s][c] += 1;
      sheets_.share_above[s][c] += h > 0 ? 1.0F : 0.0F;
    }
    if (!clear) continue;
    ++seen[s][above];
    ++total[s];
  }
  for (std::size_t s = 0; s < sheets_.count; ++s)
    for (std::size_t c = 0; c < sheets_.count; ++c)
      sheets_.share_above[s][c] = sided[s][c] > 0 ? sheets_.share_above[s][c] / sided[s][c] : 0.5F;
  const double share = model_.tolerances.noise < exact_noise ? 0 : rare;
  for (std::size_t s = 0; s < sheets_.count; ++s) {
    sheets_.data_sides[s] = total[s] == 0 ? ~std::uint64_t{0} : 0;
    for (std::uint32_t pattern = 0; pattern < 64; ++pattern)
      if (seen[s][pattern] > share * static_cast<double>(total[s]))
        sheets_.data_sides[s] |= std::uint64_t{1} << pattern;
  }
}

// With noise a wide look may be too much for one quadric a sheet.
bool SheetProbe::too_wide() const {
  const double limit = poor_fit * model_.tolerances.noise + poor_floor;
  for (std::size_t s = 0; s < sheets_.count; ++s)
    if (sheets_.sheet[s].deviation > limit) return true;
  return false;
}

}  // namespace spigolo
