// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/open_air.cpp
#include "spigolo/trace/open_air.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace spigolo {
namespace {

constexpr double bare = 1.3;     // [spacings] round a place without a point: that happens ...
constexpr double barest = 1.75;  // [spacings] ... but not this, in the middle of ...
constexpr double least_air = 2;  // [spacings] ... a stretch so long: chance 1e-5 for random samples
constexpr double close = 0.8;    // [spacings] to a point beside the ends that are left
constexpr double by_noise = 2;   // [noise] more
constexpr double widest_mouth = 6;       // [spacings] of a slot that a chain may have led across
constexpr double narrowest_mouth = 1.2;  // [spacings] between its walls, which are ...
constexpr double wall = 0.3;             // [spacings] ... so thick
constexpr double beside_mouth = 1.5;  // [spacings] round the chain: sheets of a crease have points
constexpr double sparse_reach = 6;    // [spacings] to the sample that tells how dense they are
constexpr double patch = 3;           // [spacings] round it in which they are counted
constexpr double usual = 1.3;         // times the spacing: so uneven are samples of one density
constexpr double look_step = 0.25;    // [spacings] along a curve
constexpr double least_apart = 0.3;   // [spacings] places of a guide
constexpr double least_arc = 4;       // [spacings] of a rim that is left

// From one arc length of a guide to another; round the seam of a closed one if `to` is past it.
struct Stretch {
  double from = 0, to = 0;
};

// How many times the spacing samples are apart near a place, where they are sparse; else 1.
double sparseness(const Survey& survey, const Vec3& p) {
  const auto near = survey.points_near(p, sparse_reach);
  if (near.empty()) return 1;
  const Vec3 nearest = *std::min_element(near.begin(), near.end(), [&](auto& a, auto& b) {
    return squared_distance(a, p) < squared_distance(b, p);
  });
  const auto count = static_cast<double>(survey.points_near(nearest, patch).size());
  return std::max(1.0, patch * std::sqrt(pi / count) / usual);
}

bool is_bare(const Survey& survey, const Vec3& p, double radius) {
  const double r = radius + by_noise * survey.noise();
  if (!survey.points_near(p, r).empty()) return false;
  const double times = sparseness(survey, p);
  return times <= 1 || survey.points_near(p, r * times).empty();
}

// Bare stretches between the first and the last step of a guide; of a closed one the steps begin
// at one that is not bare. They are as long as their ends are apart: a guide that leaves its
// samples at a tight bend and comes back to them has not crossed a gap.
std::vector<Stretch> air_along(const Guide& guide, const Survey& survey) {
  const auto count = static_cast<std::size_t>(std::ceil(guide.length() / look_step));
  const double step = guide.length() / static_cast<double>(count);
  const std::size_t steps = guide.closed ? count : count + 1;
  const auto place = [&](std::size_t k) { return guide.at(static_cast<double>(k % steps) * step); };
  std::vector<char> air(steps);
  for (std::size_t k = 0; k < steps; ++k) air[k] = is_bare(survey, place(k), bare);
  std::size_t first = 0;
  while (guide.closed && first < steps && air[first]) ++first;
  std::vector<Stretch> found;
  for (std::size_t k = first; k < first + steps; ++k) {
    if (!air[k % steps]) continue;
    const std::size_t begin = k;
    bool barest_seen = false;
    for (; k < first + steps && air[k % steps]; ++k)
      barest_seen |= is_bare(survey, place(k), barest);
    if (barest_seen && distance(place(begin), place(k - 1)) + step >= least_air)
      found.push_back({static_cast<double>(begin) * step, static_cast<double>(k - 1) * step});
  }
  return found;
}

// A curve goes on no farther than there are points beside it.
Stretch left_between(const Guide& guide, const Survey& survey, Stretch s, bool front, bool back) {
  const auto at = [&](double arc) {
    return guide.at(arc > guide.length() ? arc - guide.length() : arc);
  };
  while (front && s.from < s.to && is_bare(survey, at(s.from), close)) s.from += look_step;
  while (back && s.from < s.to && is_bare(survey, at(s.to), close)) s.to -= look_step;
  return s;
}

// What is left of a guide between the stretches of air.
std::vector<Stretch> on_surface(const Guide& guide, const Survey& survey,
                                const std::vector<Stretch>& air) {
  std::vector<Stretch> left;
  const std::size_t pieces = air.size() + (guide.closed ? 0 : 1);
  for (std::size_t i = 0; i < pieces; ++i) {
    const bool first = !guide.closed && i == 0, last = !guide.closed && i == air.size();
    const double from = first ? 0 : air[guide.closed ? i : i - 1].to;
    const double to = last                                  ? guide.length()
                      : guide.closed && i + 1 == air.size() ? air[0].from + guide.length()
                                                            : air[guide.closed ? i + 1 : i].from;
    left.push_back(left_between(guide, survey, {from, to}, !first, !last));
  }
  std::erase_if(left, [](const Stretch& s) { return s.to - s.from < least_apart; });
  return left;
}

std::vector<Vec3> places_in(const Guide& guide, const Stretch& s) {
  const auto at = [&](double arc) {
    return guide.at(arc > guide.length() ? arc - guide.length() : arc);
  };
  std::vector<Vec3> places{at(s.from)};
  for (int round = 0; round < 2; ++round)
    for (std::size_t i = 0; i + (guide.closed ? 1 : 0) < guide.places.size(); ++i) {
      const double arc = guide.arc[i] + round * guide.length();
      if (arc > s.from + least_apart && arc < s.to - least_apart) places.push_back(guide.places[i]);
    }
  places.push_back(at(s.to));
  return places;
}

// A piece of a curve between junctions; ends at a stretch of air are free.
RawCurve piece_of(const RawCurve& curve, const Guide& guide, const Stretch& s) {
  RawCurve piece{
      {places_in(guide, s), false, curve.chain.bridged}, {no_junction, no_junction}, curve.cut};
  auto& places = piece.chain.places;
  if (!guide.closed && s.from <= 0 && curve.junction[0] != no_junction) {
    piece.junction[0] = curve.junction[0];
    places.erase(places.begin());
  }
  if (!guide.closed && s.to >= guide.length() && curve.junction[1] != no_junction) {
    piece.junction[1] = curve.junction[1];
    places.pop_back();
  }
  return piece;
}

CurveDraft piece_of(const CurveDraft& draft, const Stretch& s,
                    std::span<const CreaseSample> samples, double window) {
  CurveDraft piece;
  piece.guide.places = places_in(draft.guide, s);
  measure(piece.guide);
  piece.bridged = draft.bridged;
  piece.form = draft.form;
  for (int round = 0; round < 2; ++round)
    for (const Member& m : draft.members) {
      const double arc = m.arc + round * draft.guide.length();
      if (arc >= s.from && arc <= s.to) piece.members.push_back({arc - s.from, m.sample});
    }
  piece.stations = smooth_along(piece.guide, piece.members, samples, window);
  return piece;
}

// The piece of a chain that led from one corner of a slot's mouth to the other: nothing between.
bool spans_a_mouth(const RawCurve& curve, const Guide& guide, const Survey& survey) {
  const double half = guide.length() / 2 - wall - by_noise * survey.noise();
  if (!curve.cut || curve.junction[0] == no_junction || curve.junction[1] == no_junction ||
      guide.length() > widest_mouth || half < narrowest_mouth / 2)
    return false;
  const Vec3 middle = guide.at(guide.length() / 2), t = guide.direction(guide.length() / 2);
  const double wide = beside_mouth * sparseness(survey, middle);
  const auto near = survey.points_near(middle, std::hypot(wide, half));
  return std::none_of(near.begin(), near.end(),
                      [&](const Vec3& p) { return std::abs(dot(p - middle, t)) < half; });
}

}  // namespace

void cut_open_air(RawNetwork& network, const Survey& survey, double scatter) {
  std::vector<RawCurve> curves;
  bool cut = false;
  for (RawCurve& curve : network.curves) {
    const Guide guide = guide_of(curve, network.junctions);
    if (spans_a_mouth(curve, guide, survey)) {
      cut = true;
      continue;
    }
    const std::vector<Stretch> air = air_along(guide, survey);
    cut |= !air.empty();
    if (air.empty())
      curves.push_back(std::move(curve));
    else
      for (const Stretch& s : on_surface(guide, survey, air))
        curves.push_back(piece_of(curve, guide, s));
  }
  network.curves = std::move(curves);
  std::erase_if(network.curves, [](const RawCurve& c) { return c.chain.places.empty(); });
  if (cut) network = prune(std::move(network), least_curve(scatter));
}

void cut_open_air(std::vector<CurveDraft>& drafts, const Survey& survey,
                  std::span<const CreaseSample> samples, double window) {
  std::vector<CurveDraft> left;
  for (CurveDraft& draft : drafts) {
    const std::vector<Stretch> air = air_along(draft.guide, survey);
    if (air.empty())
      left.push_back(std::move(draft));
    else
      for (const Stretch& s : on_surface(draft.guide, survey, air))
        if (s.to - s.from >= least_arc) left.push_back(piece_of(draft, s, samples, window));
  }
  drafts = std::move(left);
}

}  // namespace spigolo
