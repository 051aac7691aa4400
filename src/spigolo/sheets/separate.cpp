// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/separate.cpp
#include "spigolo/sheets/separate.h"

#include <algorithm>
#include <cmath>

#include "spigolo/sheets/heights.h"

namespace spigolo {
namespace {

constexpr double exact_noise = 0.02;  // [spacings] with less, fits are as exact as the data
constexpr double distrust = 2;        // [spacings] from a sheet: on none of them
constexpr double plane_gain = 12;
constexpr double far = 0.6;  // share of the width: a sheet that begins there is a plane
constexpr int exact_rounds = 2, noisy_rounds = 4;
constexpr double side_floor = 1e-4, side_noise = 0.3;   // [spacings], [standard deviations]
constexpr double merge_noise = 1.15;                    // [standard deviations]
constexpr double merge_cosine = 0.8, merge_ratio = 20;  // of normals; of an F-test on the residuals
constexpr double most_cost = 9;                         // [variances] of a point on no sheet
constexpr std::size_t fewest = 40;                   // points that are looked at by a narrowed look
constexpr double poor_fit = 1.5, poor_floor = 0.05;  // [standard deviations], [spacings]
constexpr double least_ridge = 3e-9, exact_ridge = 1e-5, noisy_ridge = 1e-2;

}  // namespace

// Curvature that samples hardly determine is worth no more than their noise lets it be.
double fit_ridge(double noise) {
  return noise < exact_noise ? std::clamp(noise * noise, least_ridge, exact_ridge) : noisy_ridge;
}

SheetSeparator::SheetSeparator(const SheetModel& model, double noise)
    : model_(model),
      seeder_(model),
      unit_(std::max({exact_noise, model.tolerances.noise, noise})),
      rare_(noise > 0 ? rare_at_places : rare) {}

void SheetSeparator::take_one(SheetRegion& region) {
  r_ = &region;
  r_->sheets.count = 1;
  r_->sheets.data_sides.fill(0);
  r_->label.assign(r_->points.size(), 0);
  const std::uint32_t nearest = r_->found.front().index;
  r_->sheets.sheet[0] = model_.own[nearest];
  fit();
}

bool SheetSeparator::separate(SheetRegion& region, bool join) {
  r_ = &region;
  r_->sheets.tolerance = std::max(side_floor, side_noise * model_.tolerances.noise);
  seeder_.seed(region);
  return settle(model_.tolerances.noise < exact_noise ? exact_rounds : noisy_rounds, join);
}

void SheetSeparator::start_from(const LocalSheets& sheets, SheetRegion& region, int rounds,
                                bool join) {
  r_ = &region;
  r_->sheets = sheets;
  r_->label.resize(r_->points.size());
  settle(rounds, join);
}

bool halve(SheetRegion& region) {
  const std::size_t k = region.points.size() / 2;
  if (k < fewest) return false;
  region.found.resize(k), region.points.resize(k);
  region.smoothing /= std::sqrt(2.0);
  return true;
}

bool SheetSeparator::fits_badly(const LocalSheets& sheets) const {
  const double limit = poor_fit * unit_ + poor_floor;
  for (std::size_t s = 0; s < sheets.count; ++s)
    if (sheets.sheet[s].deviation > limit) return true;
  return false;
}

void SheetSeparator::label(SheetRegion& region) {
  r_ = &region;
  r_->label.resize(r_->points.size());
  assign();
}

bool SheetSeparator::settle(int rounds, bool join) {
  bool joined = false;
  for (int round = 0; round < rounds; ++round) {
    assign();
    fit();
    while (join && model_.tolerances.noise >= exact_noise && r_->sheets.count > 1 && merge()) {
      joined = true;
      fit();
    }
    if (r_->sheets.count < 2) break;
    note_sides();
  }
  return joined;
}

// Heights of the points over every sheet, sheet by sheet.
void SheetSeparator::measure(std::span<const Vec3> points) {
  heights_.resize(r_->sheets.count * points.size());
  for (std::size_t s = 0; s < r_->sheets.count; ++s)
    heights(r_->sheets.sheet[s], points, &heights_[s * points.size()]);
}

void SheetSeparator::assign() {
  const std::size_t n = r_->points.size();
  measure(r_->points);
  for (std::size_t t = 0; t < n; ++t)
    r_->label[t] = static_cast<std::int8_t>(membership(t, n).sheet);
}

// The sheet whose valid part is nearest, of measured point t of n.
SheetSeparator::Membership SheetSeparator::membership(std::size_t t, std::size_t n) const {
  const LocalSheets& sheets = r_->sheets;
  Membership best{-1, distrust * distrust};
  std::array<double, LocalSheets::most> h{};
  std::uint32_t above = 0, open = 0;
  for (std::size_t s = 0; s < sheets.count; ++s) {
    h[s] = heights_[s * n + t];
    if (h[s] > 0) above |= 1U << s;
    if (std::abs(h[s]) <= sheets.tolerance) open |= 1U << s;
  }
  const double cut = most_cost * unit_ * unit_;
  for (std::size_t s = 0; s < sheets.count; ++s) {
    double cost = h[s] * h[s];
    if (cost >= std::max(best.cost, cut)) continue;
    if (sheets.count > 1 && !sheets.has_data(s, above, open)) {
      double over = 0;
      for (std::size_t c = 0; c < sheets.count; ++c)
        if (c != s) over = std::max(over, h[c] * h[c]);
      cost += over;
    }
    if (cost < best.cost) best = {static_cast<int>(s), cost};
  }
  return best;
}

// -2 log of the odds of measured point t of n [variances]. Where several valid sheets pass, the
// nearest of them is near by chance; so the odds are those of a mixture of them.
double SheetSeparator::badness(std::size_t t, std::size_t n) const {
  const double variance = unit_ * unit_;
  double likelihood = 0, valid = 0;
  for (std::size_t s = 0; s < r_->sheets.count && r_->sheets.count > 1; ++s) {
    const double h = heights_[s * n + t];
    if (h * h >= most_cost * variance || !is_above_surface(s, t, n)) continue;
    likelihood += std::exp(-0.5 * h * h / variance), valid += 1;
  }
  return valid > 1 ? -2 * std::log(likelihood / valid) : membership(t, n).cost / variance;
}

double SheetSeparator::score(SheetRegion& region, std::size_t stride) {
  r_ = &region;
  looked_at_.clear();
  for (std::size_t t = 0; t < r_->points.size(); t += stride) looked_at_.push_back(r_->points[t]);
  measure(looked_at_);
  note_cosines();
  double sum = 0;
  for (std::size_t t = 0; t < looked_at_.size(); ++t)
    sum += std::min(most_cost, badness(t, looked_at_.size()));
  const auto n = static_cast<double>(r_->points.size());
  int coefficients = 0;
  for (std::size_t s = 0; s < r_->sheets.count; ++s)
    coefficients += r_->sheets.sheet[s].is_curved() ? 6 : 3;
  return static_cast<double>(stride) * sum + coefficients * std::log(n);
}

// One quadric to the points labelled s (or also with one of them s), the nearer to the r_->center
// the weightier.
Sheet SheetSeparator::fit_labelled(std::size_t s, std::size_t also) {
  const bool exact = model_.tolerances.noise < exact_noise;
  const auto on = [&](std::size_t t) {
    return r_->label[t] == static_cast<int>(s) || r_->label[t] == static_cast<int>(also);
  };
  weights_.resize(r_->points.size());
  double nearest = infinity;
  for (std::size_t t = 0; t < r_->points.size(); ++t)
    if (on(t)) nearest = std::min(nearest, r_->found[t].squared_distance);
  const double width = r_->smoothing * r_->smoothing * r_->spacing * r_->spacing + nearest;
  for (std::size_t t = 0; t < r_->points.size(); ++t)
    weights_[t] =
        on(t) ? std::exp((nearest - squared_distance(r_->points[t], r_->center)) / width) : 0;
  return fit_weighted_sheet(r_->points, weights_, r_->center,
                            normal_at(r_->sheets.sheet[s], r_->center), r_->spacing,
                            fit_ridge(model_.tolerances.noise),
                            exact                         ? 0
                            : nearest > far * far * width ? infinity
                                                          : plane_gain);
}

// Joins the first two sheets that one quadric explains as well as two do; noise splits what is one.
bool SheetSeparator::merge() {
  for (std::size_t a = 0; a < r_->sheets.count; ++a) {
    for (std::size_t b = a + 1; b < r_->sheets.count; ++b) {
      const Sheet& first = r_->sheets.sheet[a];
      const Sheet& second = r_->sheets.sheet[b];
      const double cosine =
          std::abs(dot(normal_at(first, r_->center), normal_at(second, r_->center)));
      if (cosine < merge_cosine) continue;
      const double freedom = std::max(1.0, first.support + second.support - 12.0);
      const double apart = (first.deviation * first.deviation * first.support +
                            second.deviation * second.deviation * second.support) /
                           (first.support + second.support);
      const Sheet joint = fit_labelled(a, b);
      if (joint.deviation > merge_noise * unit_ &&
          joint.deviation * joint.deviation > (1 + merge_ratio / freedom) * apart)
        continue;
      for (std::int8_t& label : r_->label) {
        if (label == static_cast<int>(b)) label = static_cast<std::int8_t>(a);
        if (label > static_cast<int>(b)) --label;
      }
      r_->sheets.sheet[a] = joint;
      for (std::size_t c = b; c + 1 < r_->sheets.count; ++c)
        r_->sheets.sheet[c] = r_->sheets.sheet[c + 1];
      --r_->sheets.count;
      return true;
    }
  }
  return false;
}

void SheetSeparator::fit() {
  std::size_t kept = 0;
  for (std::size_t s = 0; s < r_->sheets.count; ++s) {
    const Sheet sheet = fit_labelled(s, s);
    if (!sheet.fitted()) {
      for (std::int8_t& label : r_->label)
        if (label == static_cast<int>(s)) label = -1;
      continue;
    }
    for (std::int8_t& label : r_->label)
      if (label == static_cast<int>(s)) label = static_cast<std::int8_t>(kept);
    r_->sheets.sheet[kept++] = sheet;
  }
  r_->sheets.count = kept;
}

}  // namespace spigolo
