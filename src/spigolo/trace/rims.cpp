// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/rims.cpp
#include "spigolo/trace/rims.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <tuple>

#include "spigolo/core/parallel.h"
#include "spigolo/trace/place_grid.h"

namespace spigolo {
namespace {

constexpr double smallest = 0.7, largest = 4;   // [spacings] radius
constexpr double off_plane = 0.05;              // [spacings] of marks on the plane of a rim
constexpr double off_circle = 0.55;             // [spacings] single marks see tight rims inexactly
constexpr std::size_t most_near = 28;           // marks round one that are tried
constexpr std::size_t bins = 12;                // round a rim
constexpr std::size_t least_bins = 6;           // with marks, where a wall confirms the rim
constexpr std::size_t alone_bins = 9;           // where none does
constexpr double alone_residual = 0.25;         // [spacings] rms of the marks there
constexpr double wall_from = 0.2, wall_to = 3;  // [spacings] above or below the plane
constexpr double wall_slack = 0.9;              // [spacings] off the circle of the marks
constexpr double wall_residual = 0.02;          // [spacings] a wall is round and upright
constexpr std::size_t wall_bins = 7;
constexpr double beyond = 1.5, beyond_slack = 0.1;  // [spacings] behind the plane, off the wall
constexpr std::size_t beyond_bins = 4;
constexpr double apart = 0.6;       // [spacings] two rims over each other
constexpr double guide_step = 0.4;  // [spacings]
constexpr double exact = 1e-6;      // [spacings] residuals below this are none

struct Rim {
  CircleFit circle;
  std::size_t hits = 0;  // bins with marks
  std::uint32_t seed = 0;
};

// Which bins round a circle have marks or points.
class Round {
 public:
  explicit Round(const CircleFit& circle)
      : circle_(circle), e_(any_perpendicular(circle.axis)), f_(cross(circle.axis, e_)) {}

  void add(const Vec3& p) {
    const Vec3 d = p - circle_.center;
    const double turn = std::atan2(dot(d, f_), dot(d, e_)) / (2 * pi) + 0.5;
    hit_.set(std::min(bins - 1, static_cast<std::size_t>(turn * bins)));
  }
  std::size_t count() const { return hit_.count(); }

 private:
  CircleFit circle_;
  Vec3 e_, f_;
  std::bitset<bins> hit_;
};

double above(const CircleFit& circle, const Vec3& p) { return dot(p - circle.center, circle.axis); }

double outside(const CircleFit& circle, const Vec3& p) {
  return norm(p - circle.center - circle.axis * above(circle, p)) - circle.radius;
}

bool on_rim(const CircleFit& circle, const Vec3& p) {
  return std::abs(above(circle, p)) < off_plane && std::abs(outside(circle, p)) < off_circle;
}

// The circle through a mark and two near it that most of the marks round it lie on.
std::optional<Rim> best_circle(std::uint32_t seed, std::span<const Vec3> near) {
  std::optional<Rim> best;
  for (std::size_t j = 1; j < near.size(); ++j)
    for (std::size_t k = j + 1; k < near.size(); ++k) {
      const auto circle = circle_through(near[0], near[j], near[k]);
      if (!circle || circle->radius < smallest || circle->radius > largest) continue;
      Round round(*circle);
      for (const Vec3& p : near)
        if (on_rim(*circle, p)) round.add(p);
      if (!best || round.count() > best->hits) best = Rim{*circle, round.count(), seed};
    }
  return best && best->hits >= least_bins ? best : std::nullopt;
}

// A wall that goes on behind the plane has no rim there.
bool goes_on(const CircleFit& wall, std::span<const Vec3> points, double side) {
  Round round(wall);
  for (const Vec3& p : points) {
    const double height = side * above(wall, p);
    if (height > wall_from && height < beyond && std::abs(outside(wall, p)) < beyond_slack)
      round.add(p);
  }
  return round.count() >= beyond_bins;
}

// The round wall that stands on the plane of a rim, on one side of it.
std::optional<CircleFit> wall_of(const CircleFit& rim, std::span<const Vec3> points, double side) {
  std::vector<Vec3> feet;
  Round round(rim);
  for (const Vec3& p : points) {
    const double height = side * above(rim, p);
    if (height < wall_from || height > wall_to || std::abs(outside(rim, p)) > wall_slack) continue;
    feet.push_back(p - rim.axis * above(rim, p));
    round.add(p);
  }
  if (round.count() < wall_bins) return std::nullopt;
  auto circle = fit_circle(feet, exact);
  if (!circle || circle->residual > wall_residual || circle->radius < smallest ||
      distance(circle->center, rim.center) > wall_slack ||
      std::abs(circle->radius - rim.radius) > wall_slack)
    return std::nullopt;
  const auto off = std::count_if(feet.begin(), feet.end(),
                                 [&](const Vec3& p) { return circle->distance(p) > off_plane; });
  if (3 * off > static_cast<std::ptrdiff_t>(feet.size())) return std::nullopt;
  circle->axis = rim.axis;
  return goes_on(*circle, points, -side) ? std::nullopt : circle;
}

// A rim as its wall has it, or as its marks do if they are many.
std::optional<Rim> confirm(Rim rim, std::span<const Vec3> marks, const Survey& survey) {
  const auto points = survey.points_near(rim.circle.center, std::hypot(largest + 1, wall_to));
  for (const double side : {1.0, -1.0})
    if (const auto wall = wall_of(rim.circle, points, side)) {
      rim.circle = *wall;
      return rim;
    }
  std::vector<Vec3> on;
  for (const Vec3& p : marks)
    if (on_rim(rim.circle, p)) on.push_back(p);
  const auto circle = fit_circle(on, exact);
  if (rim.hits < alone_bins || !circle || circle->residual > alone_residual ||
      circle->radius < smallest || circle->radius > largest)
    return std::nullopt;
  rim.circle = *circle;
  return rim;
}

std::optional<Rim> rim_at(std::uint32_t seed, std::span<const CreaseSample> marks,
                          const PlaceGrid& grid, const Survey& survey) {
  std::vector<std::pair<double, std::uint32_t>> order;
  grid.within(marks[seed].place, 2 * largest, [&](std::uint32_t j) {
    order.push_back({squared_distance(marks[seed].place, marks[j].place), j});
  });
  std::sort(order.begin(), order.end());
  if (order.size() > most_near) order.resize(most_near);
  std::vector<Vec3> near;
  for (const auto& [d, j] : order) near.push_back(marks[j].place);
  const auto rim = best_circle(seed, near);
  return rim ? confirm(*rim, near, survey) : std::nullopt;
}

// Two finds that cannot both be there: they lie in one plane and cross or touch.
bool exclude(const CircleFit& a, const CircleFit& b) {
  return std::abs(dot(a.axis, b.axis)) > 0.9 && std::abs(above(a, b.center)) < apart &&
         distance(a.center, b.center) < a.radius + b.radius;
}

CurveDraft draft_of(const Rim& rim, std::span<const CreaseSample> marks) {
  const CircleFit& circle = rim.circle;
  const Vec3 x = any_perpendicular(circle.axis), y = cross(circle.axis, x);
  CurveDraft draft;
  draft.guide.closed = true;
  const double steps = std::ceil(2 * pi * circle.radius / guide_step);
  for (double k = 0; k <= steps; ++k) {
    const double a = 2 * pi * std::fmod(k, steps) / steps;
    draft.guide.places.push_back(circle.center +
                                 (x * std::cos(a) + y * std::sin(a)) * circle.radius);
  }
  measure(draft.guide);
  for (std::uint32_t i = 0; i < marks.size(); ++i)
    if (on_rim(circle, marks[i].place)) {
      const Vec3 d = marks[i].place - circle.center;
      const double a = std::atan2(dot(d, y), dot(d, x));
      draft.members.push_back({(a < 0 ? a + 2 * pi : a) * circle.radius, i});
    }
  std::sort(draft.members.begin(), draft.members.end(), [](const Member& a, const Member& b) {
    return std::tie(a.arc, a.sample) < std::tie(b.arc, b.sample);
  });
  draft.stations = smooth_along(draft.guide, draft.members, marks, largest);
  draft.form = circle;
  return draft;
}

}  // namespace

std::vector<CurveDraft> find_rims(std::span<const CreaseSample> marks, const Survey& survey,
                                  const Job& job) {
  std::vector<Vec3> places;
  for (const CreaseSample& m : marks) places.push_back(m.place);
  const PlaceGrid grid(places, largest);
  std::vector<std::optional<Rim>> seen(marks.size());
  parallel_for(job, "trace", marks.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      seen[i] = rim_at(static_cast<std::uint32_t>(i), marks, grid, survey);
  });
  std::vector<Rim> rims;
  for (const auto& rim : seen)
    if (rim) rims.push_back(*rim);
  std::sort(rims.begin(), rims.end(), [](const Rim& a, const Rim& b) {
    return a.hits != b.hits ? a.hits > b.hits : a.seed < b.seed;
  });
  std::vector<Vec3> centers;
  for (const Rim& rim : rims) centers.push_back(rim.circle.center);
  const PlaceGrid near(centers, 2 * largest);
  std::vector<char> taken(rims.size(), 0);
  std::vector<CurveDraft> drafts;
  for (std::size_t r = 0; r < rims.size(); ++r) {
    if (taken[r]) continue;
    drafts.push_back(draft_of(rims[r], marks));
    near.within(centers[r], 2 * largest, [&](std::uint32_t other) {
      if (exclude(rims[r].circle, rims[other].circle)) taken[other] = 1;
    });
  }
  return drafts;
}

}  // namespace spigolo
