// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/shares.cpp
#include "spigolo/sheets/shares.h"

#include <cmath>
#include <numbers>

namespace spigolo {
namespace {

constexpr double one_sided = 0.85;   // share of a sheet's data on one side of another that ends it
constexpr double least_odds = 1e-4;  // of a point that is on a sheet: four standard deviations

// Of a normal deviate below x.
double normal_share(double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2); }

}  // namespace

std::array<double, LocalSheets::most> shares_of(const LocalSheets& sheets, const Vec3& p,
                                                double noise) {
  std::array<double, LocalSheets::most> h{}, share{};
  for (std::size_t s = 0; s < sheets.count; ++s) h[s] = height(sheets.sheet[s], p) / noise;
  double sum = 0;
  for (std::size_t s = 0; s < sheets.count; ++s) {
    double odds = std::exp(-0.5 * h[s] * h[s]);
    for (std::size_t c = 0; c < sheets.count && odds > least_odds; ++c) {
      if (c == s) continue;
      const auto above = static_cast<double>(sheets.share_above[s][c]);
      if (above > one_sided) odds *= normal_share(h[c]);
      if (above < 1 - one_sided) odds *= normal_share(-h[c]);
    }
    share[s] = odds > least_odds ? odds : 0;
    sum += share[s];
  }
  if (sum > 0)
    for (double& x : share) x /= sum;
  return share;
}

}  // namespace spigolo
