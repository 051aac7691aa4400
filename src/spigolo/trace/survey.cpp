// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/survey.cpp
#include "spigolo/trace/survey.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace spigolo {
namespace {

constexpr double step = 1;               // [spacings] of a march or walk
constexpr int most_steps = 30;           // beyond an end
constexpr int most_misses = 6;           // in a row
constexpr double along = 2.5;            // [spacings] of crease that one look takes in, each way
constexpr double noisy_along = 20;       // [noise] more
constexpr double round_share = 0.7;      // of the radius of curvature that a look goes along
constexpr double shift = 0.5;            // [spacings] a look may move a place
constexpr double noisy_shift = 2.5;      // [noise] more
constexpr double exact_noise = 0.03;     // [spacings] with less, residuals tell right from wrong
constexpr double sure_fit = 0.003;       // [spacings] rms residual of sheets that are right
constexpr double turn_cosine = 0.88;     // of the direction seen to the one expected
constexpr double gap = 1;                // [spacings] without a member that a walk looks into
constexpr double corner_clear = 0.4;     // [spacings] before a corner the third sheet begins
constexpr std::size_t model_places = 9;  // of a march that tell how it goes on

std::vector<Vec3> in_spacings(std::span<const Vec3> points, const CreaseSamples& samples) {
  std::vector<Vec3> inside(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) inside[i] = samples.inside(points[i]);
  return inside;
}

// A look that confirms what was expected.
std::optional<CreaseSample> confirm(const Survey& survey, const SectionQuery& query) {
  const auto seen = survey.look(query);
  if (!seen || dot(seen->direction, query.direction) < turn_cosine) return std::nullopt;
  if (distance(seen->place, query.place) > shift + noisy_shift * survey.noise())
    return std::nullopt;
  const bool sure = survey.noise() < exact_noise && seen->rms < sure_fit;
  return CreaseSample{seen->place, seen->direction, seen->angle, 1, 0, sure};
}

// The few members next to a place along a guide.
std::span<const Member> members_next_to(std::span<const Member> members, double arc) {
  constexpr std::size_t each_way = 3;
  const auto at = static_cast<std::size_t>(
      std::lower_bound(members.begin(), members.end(), arc,
                       [](const Member& m, double s) { return m.arc < s; }) -
      members.begin());
  const std::size_t first = at > each_way ? at - each_way : 0;
  return members.subspan(first, std::min(members.size(), at + each_way + 1) - first);
}

double angle_of(std::span<const Member> near, std::span<const CreaseSample> samples) {
  std::vector<double> angles;
  for (const Member& m : near) angles.push_back(samples[m.sample].angle);
  if (angles.empty()) return half_pi;
  const auto middle = angles.begin() + static_cast<std::ptrdiff_t>(angles.size() / 2);
  std::nth_element(angles.begin(), middle, angles.end());
  return *middle;
}

std::int8_t convexity_of(std::span<const Member> near, std::span<const CreaseSample> samples) {
  int votes = 0;
  for (const Member& m : near) votes += samples[m.sample].convex;
  return static_cast<std::int8_t>(votes > 0 ? 1 : votes < 0 ? -1 : 0);
}

// [spacings] along a crease that bends so.
double reach_along(const Survey& survey, const Vec3& bend) {
  const double reach = along + noisy_along * survey.noise(), curvature = norm(bend);
  return curvature * reach < round_share ? reach : std::max(along, round_share / curvature);
}

// The guide near s as a smooth piece of curve.
LocalCurve course_at(const Guide& guide, double s, double reach) {
  std::vector<Vec3> near;
  for (double d = -reach; d <= reach; d += step / 2) {
    const double at = s + d;
    if (guide.closed)
      near.push_back(guide.at(std::fmod(at + guide.length(), guide.length())));
    else if (at >= 0 && at <= guide.length())
      near.push_back(guide.at(at));
  }
  return fit_local_curve(near, guide.at(s), guide.direction(s));
}

bool has_member(std::span<const Member> members, double from, double to) {
  const auto at = std::lower_bound(members.begin(), members.end(), from,
                                   [](const Member& m, double s) { return m.arc < s; });
  return at != members.end() && at->arc <= to;
}

}  // namespace

Survey::Survey(std::span<const Vec3> points, const CreaseSamples& samples, double noise,
               const Job& job)
    : cloud_(order_cloud(in_spacings(points, samples), job)), tree_(cloud_), noise_(noise) {}

std::vector<Vec3> Survey::points_near(const Vec3& place, double radius) const {
  std::vector<Neighbor> found;
  tree_.within(place - cloud_.origin, radius, found);
  std::vector<Vec3> near;
  for (const Neighbor& n : found) near.push_back(cloud_.points[n.index] + cloud_.origin);
  return near;
}

std::optional<SectionFit> Survey::look(const SectionQuery& query) const {
  const double reach = std::max(query.behind, query.ahead);
  return fit_section(points_near(query.place, std::hypot(section_radius(noise_), reach)), query);
}

std::vector<CreaseSample> march(const Survey& survey, const ChainEnd& end, double angle,
                                const std::function<bool(const CreaseSample&)>& known) {
  std::vector<CreaseSample> found;
  LocalCurve model = end.model;
  const bool exact = survey.noise() < exact_noise;
  const int patience = exact ? most_misses : 2;
  std::vector<Vec3> recent = {model.at(-4), model.at(-3), model.at(-2), model.at(-1), model.place};
  double u = 0;
  int misses = 0;
  for (int n = 0; n < most_steps && misses < patience; ++n) {
    u += step;
    SectionQuery query{model.at(u), model.along(u), model.bend, angle, survey.noise(), 0, 0};
    query.behind = reach_along(survey, model.bend);
    query.ahead = std::min(query.behind, 1.5 + survey.noise());
    const auto seen = confirm(survey, query);
    misses = seen ? 0 : misses + 1;
    if (!seen) continue;
    found.push_back(*seen);
    if (known(*seen)) break;
    angle = seen->angle;
    recent.push_back(seen->place);
    if (recent.size() > model_places) recent.erase(recent.begin());
    model = fit_local_curve(recent, seen->place, model.along(u));
    u = 0;
  }
  return found;
}

std::vector<CreaseSample> walk(const Survey& survey, const Guide& guide,
                               std::span<const Member> members,
                               std::span<const CreaseSample> samples, const WalkOptions& options) {
  std::vector<CreaseSample> found;
  const double length = guide.length(), reach = std::min(6.0, along + 10 * survey.noise());
  const double margin = corner_clear + 2 * survey.noise();
  const double count = std::max(1.0, std::round(length / step));
  for (double k = 0.5; k < count; ++k) {
    const double s = length * k / count;
    if (!options.everywhere && has_member(members, s - gap, s + gap)) continue;
    const LocalCurve course = course_at(guide, s, reach);
    const auto near = members_next_to(members, s);
    SectionQuery query{
        course.place, course.tangent, course.bend, angle_of(near, samples), survey.noise(), 0, 0};
    query.behind = query.ahead = reach_along(survey, course.bend);
    if (options.corner[0]) query.behind = std::min(query.behind, std::max(0.0, s - margin));
    if (options.corner[1]) query.ahead = std::min(query.ahead, std::max(0.0, length - s - margin));
    if (query.behind + query.ahead < 1) continue;
    auto seen = confirm(survey, query);
    if (!seen) continue;
    seen->convex = convexity_of(near, samples);
    found.push_back(*seen);
  }
  return found;
}

}  // namespace spigolo
