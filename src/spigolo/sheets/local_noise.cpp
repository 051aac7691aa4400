// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/local_noise.cpp
#include "spigolo/sheets/local_noise.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "spigolo/core/parallel.h"
#include "spigolo/index/group_search.h"
#include "spigolo/index/noise.h"

namespace spigolo {
namespace {

constexpr std::size_t grain = 512;
constexpr std::size_t asked = 20;    // neighbors
constexpr std::size_t half_of = 16;  // neighbors that the flattest half is sought in
// Lower quartiles over the neighbors, taken again: an acute edge reads as noise some five spacings
// to both sides, where even half of the neighbors lie on two sheets; what is quiet around it wears
// that away. Then what is left, where edges are many, of a noise that is the same everywhere.
constexpr double quartile = 0.25, quartile_bias = 0.72;
constexpr int wear_rounds = 5;
constexpr double exact = 0.02;         // [spacings] less noise is as good as none
constexpr double constructed = 0.001;  // [spacings] no scanner's: what scatters is structure
constexpr double uneven = 3;           // ratio of the noisiest tenth to the quietest
constexpr double level_step = 2;       // ratio of neighboring levels
constexpr double tenth = 0.1, hundredth = 0.01;
// Noise taken for too little makes edges, for too much hides a few: the limit between two levels
// lies nearer to the lower one (as a share of the way, by ratio).
constexpr double rather_up = 0.3;

double quantile(std::vector<double>& values, double share) {
  const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + place, values.end());
  return values[static_cast<std::size_t>(place)];
}

double noise_at(const SheetCloud& cloud, std::size_t i) {
  if (cloud.sheets[i].whole || cloud.neighborhoods.k < half_of) return cloud.sheets[i].deviation;
  return noise_of_flattest_half(cloud.points, i, cloud.neighborhoods.of(i),
                                cloud.spacing.of_point[i]);
}

}  // namespace

std::vector<double> estimate_local_noise(const SheetCloud& cloud, const Job& job) {
  std::vector<double> first(cloud.size()), second(cloud.size());
  const auto sweep = [&](std::vector<double>& result, double share, auto&& value_of) {
    const std::size_t n = std::min(asked, cloud.neighborhoods.k);
    const auto place = static_cast<std::size_t>(share * static_cast<double>(n));
    parallel_for(job, "", cloud.size(), grain, [&](std::size_t begin, std::size_t end) {
      std::array<double, asked + 1> values;
      std::array<std::uint32_t, asked + 1> order;
      for (std::size_t i = begin; i < end; ++i) {
        const auto row = cloud.neighborhoods.of(i);
        values[0] = value_of(i);
        for (std::size_t t = 0; t < n; ++t) values[t + 1] = value_of(row[t]);
        rank_ascending(values.data(), n + 1, place + 1, order.data());
        result[i] = values[order[place]];
      }
    });
  };
  std::vector<double> own(cloud.size());
  parallel_for(job, "", cloud.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) own[i] = noise_at(cloud, i);
  });
  sweep(first, quartile, [&](std::size_t j) { return own[j]; });
  for (int round = 0; round < wear_rounds; ++round) {
    sweep(second, quartile, [&](std::size_t j) { return first[j]; });
    first.swap(second);
  }
  sweep(second, 0.5, [&](std::size_t j) { return first[j]; });
  for (double& noise : second) noise /= quartile_bias;
  return second;
}

bool is_quiet(const SheetCloud& cloud, const Job& job) {
  // A quantile is below a limit if enough values are, so flags do for values. `low` of
  // noise_levels is never below `exact`.
  constexpr double limit = uneven * exact * quartile_bias * (1 - 1e-9);
  std::vector<unsigned char> flag(cloud.size()), next(cloud.size());
  parallel_for(job, "", cloud.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      flag[i] = cloud.sheets[i].whole && cloud.sheets[i].deviation < limit;
  });
  for (const double share : {quartile, 0.5}) {
    parallel_for(job, "", cloud.size(), grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const auto row = cloud.neighborhoods.of(i);
        const auto near = row.first(std::min(asked, row.size()));
        int quiet = flag[i];
        for (const std::uint32_t j : near) quiet += flag[j];
        next[i] = quiet > static_cast<int>(share * static_cast<double>(near.size()));
      }
    });
    flag.swap(next);
  }
  const std::size_t quiet =
      parallel_count(job, flag.size(), grain, [&](std::size_t i) { return flag[i] != 0; });
  return static_cast<double>(quiet) > (1 - tenth) * static_cast<double>(flag.size());
}

std::vector<double> noise_levels(const std::vector<double>& local, double of_cloud) {
  std::vector<double> sorted;
  for (const double noise : local)
    if (std::isfinite(noise)) sorted.push_back(noise);
  if (sorted.empty()) return {of_cloud};
  const double quiet = quantile(sorted, tenth), loud = quantile(sorted, 1 - tenth);
  const double low = std::max(quiet, exact), high = std::max(loud, exact);
  if (quiet < constructed || high < uneven * low) return {of_cloud};
  const double loudest = quantile(sorted, 1 - hundredth);
  std::vector<double> levels;
  for (double noise = low; noise < loudest * std::sqrt(level_step); noise *= level_step)
    levels.push_back(noise);
  return levels;
}

std::size_t nearest_level(const std::vector<double>& levels, double noise) {
  std::size_t best = 0;
  for (std::size_t l = 1; l < levels.size(); ++l)
    if (noise > std::pow(levels[l - 1], 1 - rather_up) * std::pow(levels[l], rather_up)) best = l;
  return best;
}

}  // namespace spigolo
