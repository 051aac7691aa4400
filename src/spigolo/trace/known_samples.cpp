// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/known_samples.cpp
#include "spigolo/trace/known_samples.h"

#include <algorithm>
#include <cmath>

namespace spigolo {
namespace {

constexpr double known_reach = 0.8;   // [spacings] a place that near to a sample is known
constexpr double known_cosine = 0.8;  // if the sample runs its way
constexpr double round_reach = 2;     // [spacings] round an end that tell its angle

std::vector<Vec3> places_of(std::span<const CreaseSample> samples) {
  std::vector<Vec3> places;
  for (const CreaseSample& s : samples) places.push_back(s.place);
  return places;
}

}  // namespace

KnownSamples::KnownSamples(std::span<const CreaseSample> samples)
    : samples_(samples), grid_(places_of(samples), round_reach) {}

double KnownSamples::angle_at(const Vec3& place) const {
  std::vector<double> angles;
  grid_.within(place, round_reach, [&](std::uint32_t i) { angles.push_back(samples_[i].angle); });
  if (angles.empty()) return half_pi;
  const auto middle = angles.begin() + static_cast<std::ptrdiff_t>(angles.size() / 2);
  std::nth_element(angles.begin(), middle, angles.end());
  return *middle;
}

std::int8_t KnownSamples::convexity_at(const Vec3& place) const {
  int votes = 0;
  grid_.within(place, round_reach, [&](std::uint32_t i) { votes += samples_[i].convex; });
  return static_cast<std::int8_t>(votes > 0 ? 1 : votes < 0 ? -1 : 0);
}

bool KnownSamples::knows(const CreaseSample& seen, const Vec3& from) const {
  if (distance(seen.place, from) <= 2 * known_reach) return false;
  bool known = false;
  grid_.within(seen.place, known_reach, [&](std::uint32_t i) {
    known |= std::abs(dot(samples_[i].direction, seen.direction)) > known_cosine;
  });
  return known;
}

std::vector<CreaseSample> march_from(const Survey& survey, const ChainEnd& end,
                                     const KnownSamples& known) {
  const Vec3 from = end.model.place;
  std::vector<CreaseSample> seen =
      march(survey, end, known.angle_at(from),
            [&](const CreaseSample& s) { return known.knows(s, from); });
  for (CreaseSample& s : seen) s.convex = known.convexity_at(from);
  return seen;
}

}  // namespace spigolo
