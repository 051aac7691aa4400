// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/passing.cpp
#include "spigolo/sheets/passing.h"

#include <algorithm>
#include <cmath>

#include "spigolo/core/parallel.h"

namespace spigolo {
namespace {

constexpr std::size_t grain = 1024;
constexpr double tiny = 1e-300;       // farther off the sheets than a double can tell
constexpr double probable = 0.3;      // so likely, a crease is said to pass
constexpr double vague = 0.27;        // ... in much noise, where places are blurred
constexpr double probable_row = 0.5;  // or a sample to be one of a row on it
// [spacings] Beside a row on the crease lies no other sample; on a lattice the next row is one
// spacing away, else they may be anywhere beyond; both are thought as likely. From the end on no
// difference is made.
constexpr double bare = 0.6, next_row = 1, undisturbed = 1.5, on_lattice = 0.5;
constexpr double sharpest = radians(115);  // the places of more acute creases are too uncertain
// [spacings] Noise from which rows cannot be told any more: where there may be some, a crease must
// pass as close as if there were, or each is marked along with what lies beside it.
constexpr double blurred = 0.35;
// Log of odds: a sample, and all together, must speak for rows.
constexpr double clear = 0.02, clear_in_all = 20;

double normal_share_below(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

double density_at(double x) { return std::exp(-0.5 * x * x) / std::sqrt(2 * pi); }

// Likelihoods of a sample: of the places of both sheets within `near` of the crease, of all of
// them, of those that a row on the crease leaves, and of that row.
struct Likelihoods {
  double within = 0, all = 0, beside = 0, row = 0;
};

Likelihoods likelihoods_of(const SheetVerdict& edge, const Vec3& d, double near, double noise) {
  Likelihoods sum;
  for (const Vec3& into : edge.into) {
    const double t = dot(d, into) / noise, off = dot(d, cross(into, edge.direction)) / noise;
    const double weight = std::exp(-0.5 * off * off), before = normal_share_below(-t);
    sum.within += weight * (normal_share_below(near / noise - t) - before);
    sum.all += weight * (1 - before);
    const double end = normal_share_below(undisturbed / noise - t);
    const double spread = (end - normal_share_below(bare / noise - t)) / (undisturbed - bare);
    const double row = density_at(t - next_row / noise) / noise;
    sum.beside += weight * (1 - end + on_lattice * row + (1 - on_lattice) * spread);
    sum.row += 0.5 * weight * density_at(t) / noise;
  }
  return sum;
}

}  // namespace

double passing_probability(const SheetVerdict& edge, const Vec3& sample, double spacing,
                           const SamplePlaces& places, double noise) {
  const Vec3 d = (sample - edge.crease_point) / spacing;
  const Likelihoods sum = likelihoods_of(edge, d, places.near, noise);
  if (sum.all < tiny) return norm(d) < places.near ? 1 : 0;
  return places.on_creases ? sum.row / (sum.row + sum.beside) : sum.within / sum.all;
}

double placed_evidence(const SheetVerdict& edge, const Vec3& sample, double spacing, double noise) {
  const Likelihoods sum = likelihoods_of(edge, (sample - edge.crease_point) / spacing, 0, noise);
  return sum.all < tiny ? 0 : std::log((sum.row + sum.beside) / sum.all);
}

namespace {

// The typical distance from a sample to the nearest one [spacings]. Even samples lie farther from
// each other than random ones, and from a crease that none of their neighbors is closer to.
double nearest_distance(std::span<const Vec3> points, const Neighborhoods& neighborhoods,
                        const Spacing& spacing) {
  std::vector<double> nearest(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    nearest[i] = distance(points[i], points[neighborhoods.of(i)[0]]) / spacing.of_point[i];
  const auto middle = nearest.begin() + static_cast<std::ptrdiff_t>(nearest.size() / 2);
  std::nth_element(nearest.begin(), middle, nearest.end());
  return *middle;
}

// Whether rows on creases explain the samples about the agreed creases better than any place does.
bool are_on_creases(std::span<const Vec3> points, const Spacing& spacing, const VerdictRows& agreed,
                    double noise) {
  double evidence = 0, count = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double s = spacing.of_point[i];
    if (agreed[i].kind != PointKind::edge || agreed[i].deviation > sharpest) continue;
    evidence += placed_evidence(agreed[i], points[i], s, noise);
    count += 1;
  }
  return evidence > std::max(clear_in_all, clear * count);
}

}  // namespace

SamplePlaces find_sample_places(std::span<const Vec3> points, const Neighborhoods& neighborhoods,
                                const Spacing& spacing, const VerdictRows& agreed, double noise) {
  SamplePlaces places;
  if (noise > blurred) return places;
  places.near = std::max(places.near, nearest_distance(points, neighborhoods, spacing));
  places.on_creases = are_on_creases(points, spacing, agreed, noise);
  return places;
}

VerdictRows drop_passed_by(std::span<const Vec3> points, const Spacing& spacing,
                           const SamplePlaces& places, double noise, const VerdictRows& verdicts,
                           const Job& job) {
  const double least = places.on_creases ? probable_row : noise > blurred ? vague : probable;
  const auto passes = [&](const SheetVerdict& v, std::size_t i) {
    return v.kind != PointKind::edge ||
           passing_probability(v, points[i], spacing.of_point[i], places, noise) >= least;
  };
  return {points.size(),
          parallel_collect<FoundVerdict>(
              job, points.size(), grain, [&](std::size_t begin, std::size_t end, auto& kept) {
                for (std::size_t i = begin; i < end; ++i)
                  if (!verdicts[i].says_nothing() && passes(verdicts[i], i))
                    kept.emplace_back(static_cast<std::uint32_t>(i), verdicts[i]);
              })};
}

}  // namespace spigolo
