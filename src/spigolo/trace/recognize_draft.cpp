// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/recognize_draft.cpp - which lines and circles curves on their way are
#include <algorithm>
#include <cmath>

#include "spigolo/trace/shape_curve.h"

namespace spigolo {
namespace {

constexpr double exact = 1e-6;  // [spacings] residuals below this are none
constexpr std::size_t least_members = 4;
constexpr double least_sweep = 0.25;  // [rad] of an arc; less tells no radius
constexpr double most_share = 0.8;    // of a curve that follows the form it is taken for
constexpr double stray = 0.5;         // [spacings] the rest may be off
constexpr double sure_step = 2.5;     // [spacings] along the curve that a sure place stands for
constexpr double sure_share = 0.4;    // of a curve that sure places speak for
constexpr double sure_strays = 0.03;  // share of them that may be off a form
constexpr double sure_stray = 1.5;    // [spacings] the curve may be off where nothing is sure

std::vector<Vec3> member_places(const CurveDraft& draft, std::span<const CreaseSample> samples) {
  std::vector<Vec3> places;
  for (const Member& m : draft.members) places.push_back(samples[m.sample].place);
  return places;
}

// The places of a draft that are sure, if they lie along most of it.
std::vector<Vec3> sure_places(const CurveDraft& draft, std::span<const CreaseSample> samples) {
  std::vector<Vec3> places;
  double covered = 0, upto = -infinity;
  for (const Member& m : draft.members) {
    if (!samples[m.sample].sure) continue;
    places.push_back(samples[m.sample].place);
    covered += std::min(sure_step, m.arc - upto);
    upto = m.arc;
  }
  if (covered < sure_share * draft.guide.length()) places.clear();
  return places;
}

// Whether all sure places but a few follow a form, and the rest of the curve is not far from it.
template <class Distance>
bool sure_to_follow(const CurveDraft& draft, std::span<const Vec3> sure, double tolerance,
                    const Distance& distance) {
  const auto strays = std::count_if(sure.begin(), sure.end(),
                                    [&](const Vec3& p) { return distance(p) > tolerance; });
  const double most = std::max(1.0, sure_strays * static_cast<double>(sure.size()));
  return static_cast<double>(strays) <= most &&
         std::all_of(draft.stations.begin(), draft.stations.end(),
                     [&](const Station& s) { return distance(s.place) < sure_stray; });
}

// Whether nearly all stations are within tolerance of a form, and none is far from it: a few may
// follow samples that saw the wrong sheets.
template <class Distance>
bool follows(const CurveDraft& draft, std::span<const Vec3> sure, double tolerance,
             const Distance& distance) {
  if (sure.size() >= least_members) return sure_to_follow(draft, sure, tolerance, distance);
  std::vector<double> off;
  for (const Station& s : draft.stations) off.push_back(distance(s.place));
  std::sort(off.begin(), off.end());
  const auto most = static_cast<std::size_t>(most_share * static_cast<double>(off.size() - 1));
  return off[most] <= tolerance && off.back() <= stray + 2 * tolerance;
}

double off_line(const LineFit& line, const Vec3& p) {
  return norm(cross(p - line.place, line.direction));
}

}  // namespace

void recognize(CurveDraft& draft, std::span<const CreaseSample> samples,
               const ShapeTolerances& tolerances) {
  draft.form = std::monostate{};
  const std::vector<Vec3> sure = sure_places(draft, samples);
  const std::vector<Vec3> places =
      sure.size() >= least_members ? sure : member_places(draft, samples);
  if (places.size() < least_members) return;
  const LineFit line = fit_line(places, exact);
  const auto from_line = [&](const Vec3& p) { return off_line(line, p); };
  if (!draft.guide.closed && follows(draft, sure, tolerances.shape, from_line)) {
    draft.form = line;
    return;
  }
  const auto circle = fit_circle(places, exact);
  if (!circle || draft.guide.length() < least_sweep * circle->radius) return;
  if (follows(draft, sure, tolerances.shape, [&](const Vec3& p) { return circle->distance(p); }))
    draft.form = *circle;
}

}  // namespace spigolo
