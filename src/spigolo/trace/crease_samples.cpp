// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/crease_samples.cpp
#include "spigolo/trace/crease_samples.h"

#include <algorithm>
#include <cmath>

#include "spigolo/core/parallel.h"
#include "spigolo/core/symmetric3.h"
#include "spigolo/index/order.h"
#include "spigolo/trace/local_fit.h"
#include "spigolo/trace/place_grid.h"

namespace spigolo {
namespace {

constexpr std::size_t grain = 64;
constexpr double window = 3.5;          // [spacings] samples that far along speak for each other
constexpr double noisy_window = 8;      // [scatters] more, since each says less
constexpr double widest_window = 9;     // [spacings]
constexpr double exact_scatter = 0.03;  // [spacings] with less, samples stay where they are
constexpr double kin_cosine = 0.7;      // of directions along one crease
constexpr double kin_reach = 0.6;       // [spacings] off the line of one crease
constexpr double kin_slope = 0.35;      // more of it for each spacing along: creases bend
constexpr double stray = 0.25;          // [spacings] off what the neighbors make of the crease
constexpr double exact_stray = 0.03;    // [spacings] the same where samples do not scatter
constexpr int least_kin = 2;            // a sample that fewer agree with is chance

double window_of(double scatter) {
  return std::min(widest_window, window + noisy_window * scatter);
}

// The samples near `of` that may lie on the same crease.
void find_kin(const std::vector<CreaseSample>& samples, const PlaceGrid& grid,
              const CreaseSample& of, double scatter, std::vector<Vec3>& kin) {
  kin.clear();
  grid.within(of.place, window_of(scatter), [&](std::uint32_t j) {
    const CreaseSample& other = samples[j];
    if (std::abs(dot(other.direction, of.direction)) < kin_cosine) return;
    const Vec3 d = other.place - of.place;
    const double along = std::abs(dot(d, of.direction));
    const double across = norm(cross(d, of.direction));
    if (across <= kin_reach + 2 * scatter + kin_slope * along) kin.push_back(other.place);
  });
}

// Samples without a direction take that of the samples round them.
void give_directions(std::vector<CreaseSample>& samples, const PlaceGrid& grid, double scatter) {
  for (CreaseSample& sample : samples) {
    if (squared_norm(sample.direction) > 0) continue;
    Symmetric3 spread;
    grid.within(sample.place, window + 2 * scatter,
                [&](std::uint32_t j) { spread.add(samples[j].place - sample.place); });
    sample.direction = largest_axis(spread).axis;
  }
}

std::vector<Vec3> places_of(const std::vector<CreaseSample>& samples) {
  std::vector<Vec3> places(samples.size());
  std::transform(samples.begin(), samples.end(), places.begin(),
                 [](const CreaseSample& s) { return s.place; });
  return places;
}

// What the kin of a sample make of it: moved onto their common crease if samples scatter, weighed
// by how many agree, and dropped (weight 0) if few do or it lies apart from them.
CreaseSample settled(const CreaseSample& sample, std::span<const Vec3> kin, double scatter) {
  CreaseSample result = sample;
  const LocalCurve fit = fit_local_curve(kin, sample.place, sample.direction);
  const double off = distance(fit.place, sample.place);
  const bool agreed =
      static_cast<int>(kin.size()) > least_kin && fit.support >= least_kin &&
      off <= (scatter < exact_scatter ? exact_stray + 4 * fit.residual : stray + 2 * scatter);
  if (!agreed) {
    result.weight = 0;
    return result;
  }
  result.weight = sample.weight * fit.support / (1 + off);
  if (scatter < exact_scatter) return result;
  result.place = fit.place;
  result.direction = fit.tangent;
  return result;
}

void settle(std::vector<CreaseSample>& samples, double scatter, const Job& job) {
  const PlaceGrid grid(places_of(samples), window);
  give_directions(samples, grid, scatter);
  std::vector<CreaseSample> next(samples.size());
  parallel_for(job, "trace", samples.size(), grain, [&](std::size_t begin, std::size_t end) {
    std::vector<Vec3> kin;
    for (std::size_t i = begin; i < end; ++i) {
      find_kin(samples, grid, samples[i], scatter, kin);
      next[i] = settled(samples[i], kin, scatter);
    }
  });
  std::erase_if(next, [](const CreaseSample& s) { return s.weight <= 0; });
  samples = std::move(next);
}

}  // namespace

CreaseSamples gather_samples(std::span<const Vec3> points, const Features& features, double spacing,
                             double scatter, const Job& job) {
  CreaseSamples samples;
  std::vector<std::uint32_t> chosen;
  std::vector<Vec3> places;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (!is_finite(features.crease_point[i]) || !is_finite(points[i])) continue;
    chosen.push_back(i);
    places.push_back(points[i]);
  }
  const OrderedCloud order = order_cloud(places, job);
  samples.origin = order.origin;
  samples.unit = spacing > 0 ? spacing : 1;
  std::vector<std::uint32_t> first(order.size(), no_point);
  for (std::size_t c = chosen.size(); c-- > 0;) first[order.rank[c]] = chosen[c];
  for (const std::uint32_t i : first) {
    const CreaseSample sample{samples.inside(features.crease_point[i]), features.direction[i],
                              features.angle[i], features.strength[i], features.convex[i]};
    const PointKind kind = features.kind[i];
    if (kind == PointKind::edge) samples.edges.push_back(sample);
    if (kind == PointKind::border) samples.borders.push_back(sample);
    if (kind == PointKind::corner) samples.corners.push_back(sample.place);
    if (kind != PointKind::border) samples.marks.push_back(sample);
  }
  for (int round = 0; round < (scatter < exact_scatter ? 1 : 2); ++round)
    settle(samples.edges, scatter, job);
  for (int round = 0; round < 2; ++round) settle(samples.borders, std::max(scatter, 0.3), job);
  return samples;
}

}  // namespace spigolo
