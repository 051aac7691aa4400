// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/guide.cpp
#include "spigolo/trace/guide.h"

#include <algorithm>
#include <cmath>

#include "spigolo/trace/anchors.h"
#include "spigolo/trace/local_fit.h"
#include "spigolo/trace/place_grid.h"

namespace spigolo {
namespace {

constexpr double side_step = 0.5;         // [spacings] between the places a guide is known by
constexpr double own_cosine = 0.75;       // of the directions of a guide and its samples
constexpr double station_step = 1;        // [spacings]
constexpr std::size_t least_members = 3;  // for a local fit
constexpr double bent_window = 0.8;       // of the radius of curvature that a local fit may span
constexpr double least_window = 3;        // [spacings] that it spans in any case
constexpr double sure_reach = 4;          // [spacings] that a sure member speaks for
constexpr double trust = 1;               // [spacings] a local fit may move the guide

std::size_t segment_at(const Guide& guide, double s) {
  const auto above = std::upper_bound(guide.arc.begin() + 1, guide.arc.end() - 1, s);
  return static_cast<std::size_t>(above - guide.arc.begin()) - 1;
}

// Members with arc in [from, to] of a guide, round the seam of a closed one.
void members_between(const Guide& guide, std::span<const Member> members, double from, double to,
                     std::vector<std::uint32_t>& found) {
  found.clear();
  const auto take = [&](double a, double b) {
    auto it = std::lower_bound(members.begin(), members.end(), a,
                               [](const Member& m, double arc) { return m.arc < arc; });
    for (; it != members.end() && it->arc <= b; ++it) found.push_back(it->sample);
  };
  take(from, to);
  if (guide.closed && from < 0) take(std::max(to, from + guide.length()), guide.length());
  if (guide.closed && to > guide.length()) take(0, std::min(from, to - guide.length()));
}

// Members beside ones that are sure have no say.
void leave_to_sure(std::span<const CreaseSample> samples, std::vector<Member>& members) {
  std::vector<double> sure;
  for (const Member& m : members)
    if (samples[m.sample].sure) sure.push_back(m.arc);
  std::erase_if(members, [&](const Member& m) {
    if (samples[m.sample].sure) return false;
    const auto next = std::lower_bound(sure.begin(), sure.end(), m.arc - sure_reach);
    return next != sure.end() && *next <= m.arc + sure_reach;
  });
}

double median_angle(std::span<const std::uint32_t> near, std::span<const CreaseSample> samples) {
  std::vector<double> angles;
  for (const std::uint32_t i : near) angles.push_back(samples[i].angle);
  if (angles.empty()) return 0;
  const auto middle = angles.begin() + static_cast<std::ptrdiff_t>(angles.size() / 2);
  std::nth_element(angles.begin(), middle, angles.end());
  return *middle;
}

}  // namespace

Vec3 Guide::at(double s) const {
  const std::size_t i = segment_at(*this, s);
  const double length = arc[i + 1] - arc[i];
  const double share = length > 0 ? std::clamp((s - arc[i]) / length, 0.0, 1.0) : 0;
  return places[i] * (1 - share) + places[i + 1] * share;
}

Vec3 Guide::direction(double s) const {
  const double a = std::max(0.0, s - station_step), b = std::min(length(), s + station_step);
  return normalized(at(b) - at(a));
}

Guide guide_of(const RawCurve& curve, std::span<const Vec3> junctions) {
  Guide guide;
  guide.closed = curve.chain.closed;
  const auto add_junction = [&](int j) {
    if (j != no_junction) guide.places.push_back(junctions[static_cast<std::size_t>(j)]);
  };
  add_junction(curve.junction[0]);
  guide.places.insert(guide.places.end(), curve.chain.places.begin(), curve.chain.places.end());
  add_junction(curve.junction[1]);
  if (guide.closed) guide.places.push_back(guide.places.front());
  measure(guide);
  return guide;
}

void measure(Guide& guide) {
  guide.arc.assign(1, 0.0);
  for (std::size_t i = 1; i < guide.places.size(); ++i)
    guide.arc.push_back(guide.arc.back() + distance(guide.places[i], guide.places[i - 1]));
}

std::vector<std::vector<Member>> assign_members(std::span<const Guide> guides,
                                                std::span<const CreaseSample> samples,
                                                double reach) {
  struct Side {
    std::size_t guide;
    double arc;
    Vec3 direction;
  };
  std::vector<Side> sides;
  std::vector<Vec3> places;
  for (std::size_t g = 0; g < guides.size(); ++g)
    for (double s = 0; s <= guides[g].length(); s += side_step) {
      sides.push_back({g, s, guides[g].direction(s)});
      places.push_back(guides[g].at(s));
    }
  const PlaceGrid grid(places, reach);
  std::vector<std::vector<Member>> members(guides.size());
  for (std::uint32_t i = 0; i < samples.size(); ++i) {
    double least = infinity;
    std::uint32_t best = PlaceGrid::no_place;
    grid.within(samples[i].place, reach, [&](std::uint32_t k) {
      if (std::abs(dot(sides[k].direction, samples[i].direction)) < own_cosine) return;
      const double d = squared_distance(places[k], samples[i].place);
      if (d < least || (d == least && k < best)) least = d, best = k;
    });
    if (best == PlaceGrid::no_place) continue;
    const Side& side = sides[best];
    const double arc = side.arc + dot(samples[i].place - places[best], side.direction);
    members[side.guide].push_back({std::clamp(arc, 0.0, guides[side.guide].length()), i});
  }
  for (auto& list : members) {
    std::sort(list.begin(), list.end(), [](const Member& a, const Member& b) {
      return a.arc != b.arc ? a.arc < b.arc : a.sample < b.sample;
    });
    leave_to_sure(samples, list);
  }
  return members;
}

std::vector<Station> smooth_along(const Guide& guide, std::span<const Member> members,
                                  std::span<const CreaseSample> samples, double window) {
  const double count =
      std::max(guide.closed ? 6.0 : 2.0, std::round(guide.length() / station_step));
  const double end = guide.closed ? count - 1 : count;
  const Anchors anchors(guide, members, samples);
  std::vector<Station> stations;
  std::vector<std::uint32_t> near;
  std::vector<Vec3> places;
  for (double k = 0; k <= end; ++k) {
    const double s = guide.length() * k / count;
    Station station{s, guide.at(s), 0};
    members_between(guide, members, s - window, s + window, near);
    station.angle = median_angle(near, samples);
    if (const auto place = anchors.at(s)) {
      station.place = *place;
      stations.push_back(station);
      continue;
    }
    places.clear();
    for (const std::uint32_t i : near) places.push_back(samples[i].place);
    if (near.size() >= least_members) {
      LocalCurve fit = fit_local_curve(places, station.place, guide.direction(s));
      const double curvature = norm(fit.bend);
      if (curvature * window > bent_window && window > least_window) {
        members_between(guide, members, s - std::max(least_window, bent_window / curvature),
                        s + std::max(least_window, bent_window / curvature), near);
        places.clear();
        for (const std::uint32_t i : near) places.push_back(samples[i].place);
        if (near.size() >= least_members)
          fit = fit_local_curve(places, station.place, guide.direction(s));
      }
      if (distance(fit.place, station.place) < trust + window / 8) station.place = fit.place;
    }
    stations.push_back(station);
  }
  return stations;
}

}  // namespace spigolo
