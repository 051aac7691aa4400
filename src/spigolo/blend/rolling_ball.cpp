// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/rolling_ball.cpp
#include "spigolo/blend/rolling_ball.h"

#include <algorithm>
#include <cmath>

#include "spigolo/blend/handles.h"
#include "spigolo/blend/patch.h"
#include "spigolo/core/parallel.h"

namespace spigolo {
namespace {

// Lengths in spacings.
constexpr double exactness = 1e-6;     // of the ball's distance, and of the foot
constexpr double good_enough = 0.1;    // where a foot does not settle: the surface is not smooth
constexpr double longest_step = 2;     // on the cloud
constexpr double off_the_cloud = 2.5;  // from the nearest sample
constexpr double least_gain = 0.1, most_gain = 3;
constexpr int most_foot_steps = 60, most_tries = 40;
constexpr int patient_steps = 15;  // then steps get shorter: the surface jumps
constexpr int pieces_of_guess = 8;
constexpr double most_patched = 0.5;  // share of the strands
constexpr std::size_t grain = 4;

enum class Roll : std::uint8_t { touches, lost, off_cloud, off_face };

// The place of the cloud nearest to a point, found from a place nearby.
class NearestFoot {
 public:
  NearestFoot(const CloudSide& cloud, MlsScratch& scratch) : cloud_(cloud), scratch_(scratch) {}

  Vec3 at, normal;   // where it stands
  bool off = false;  // the cloud ended on the way

  // Steps in the tangent plane to below c, by the length that the last step taught (Barzilai and
  // Borwein): on a strongly curved surface the plain one would swing.
  bool move_below(const Vec3& c) {
    const double d = cloud_.spacing();
    Vec3 step, last_rest;
    double gain = 1;
    for (int i = 0;; ++i) {
      const Vec3 rest = (c - at) - normal * dot(c - at, normal);
      if (norm(rest) < exactness * d) return true;
      if (i == most_foot_steps) return norm(rest) < good_enough * d;
      const double learned = dot(step, last_rest - rest);
      if (learned > 0) gain = std::clamp(dot(step, step) / learned, least_gain, most_gain);
      gain = std::min(gain, double{patient_steps} / (i + 1));
      last_rest = rest;
      const Vec3 wish = rest * gain;
      if (!advance(wish * std::min(1.0, longest_step * d / norm(wish)), step)) return false;
    }
  }

 private:
  bool advance(const Vec3& wish, Vec3& step) {
    const Vec3 to = at + wish;
    const OrientedFoot foot = orient_foot(cloud_.project(to, scratch_), to, normal);
    const double most = off_the_cloud * cloud_.spacing();
    off = !foot.found || cloud_.sample_distance(foot.foot, scratch_) > most;
    step = foot.foot - at;
    if (!off) at = foot.foot, normal = foot.normal;
    return !off;
  }

  const CloudSide& cloud_;
  MlsScratch& scratch_;
};

// The ball of one strand.
class Ball {
 public:
  Ball(const Isolines& isolines, const CloudSide& cloud, int side, MlsScratch& scratch)
      : isolines_(isolines), cloud_(cloud), side_(side), foot_(cloud, scratch) {}

  Roll run(Strand& s) {
    direction_ = s.line.begin > s.at ? 1 : -1;
    range_ = std::abs(s.line.begin - s.at);
    foot_.at = s.x, foot_.normal = s.cloud_normal;
    double way = guess(s);
    const Roll found = settle(s, way);
    if (found != Roll::touches) return found;
    const IsoPoint p = place(s, way);
    s.alpha_at = s.at + direction_ * way;
    s.alpha = p.point, s.alpha_normal = p.normal;
    s.beta = foot_.at, s.beta_normal = foot_.normal;
    return Roll::touches;
  }

 private:
  IsoPoint place(const Strand& s, double way) const {
    return isolines_.at(s.line.cross, s.at + direction_ * way);
  }

  // Where the ball would touch if both sides were flat.
  double guess(const Strand& s) const {
    const double length = s.radius / std::tan(s.angle / 2) / pieces_of_guess;
    double way = 0;
    for (int i = 0; i < pieces_of_guess; ++i) {
      const double speed = norm(place(s, way).onward);
      if (speed > 0) way += length / speed;
      way = std::min(way, range_);
    }
    return way;
  }

  // How much too high the ball hangs that touches the face there.
  bool height(const Strand& s, double way, double& too_high) {
    const IsoPoint p = place(s, way);
    const Vec3 center = p.point + p.normal * (side_ * s.radius);
    if (!foot_.move_below(center)) return false;
    too_high = dot(center - foot_.at, foot_.normal) - s.radius;
    return true;
  }

  // Secant steps, kept between a way that is too short and one that is too long.
  Roll settle(const Strand& s, double& way) {
    double low = 0, high = range_, last = 0, last_value = 0;
    for (int i = 0; i < most_tries; ++i) {
      double value = 0;
      if (!height(s, way, value)) return foot_.off ? Roll::off_cloud : Roll::lost;
      if (std::abs(value) < exactness * cloud_.spacing()) return Roll::touches;
      if (value < 0 && way >= range_) return Roll::off_face;
      (value < 0 ? low : high) = way;
      const double slope = i > 0 ? (value - last_value) / (way - last)
                                 : norm(place(s, way).onward) * std::sin(s.angle);
      last = way, last_value = value;
      way -= value / slope;
      if (!(way > low)) way = (low + last) / 2;
      if (!(way < high)) way = high == range_ ? range_ : (high + last) / 2;
      if (way == last) break;
    }
    return std::abs(last_value) < good_enough * cloud_.spacing() ? Roll::touches : Roll::lost;
  }

  const Isolines& isolines_;
  const CloudSide& cloud_;
  int side_;
  NearestFoot foot_;
  double direction_ = 1, range_ = 0;
};

// Balls that run backwards are as bad as those that were not found.
void mark_folds(const BorderLoop& loop, std::vector<char>& good) {
  const std::vector<Strand>& s = loop.strands;
  const std::size_t n = s.size();
  std::vector<char> folded(n, 0);
  for (std::size_t i = 0; i + (loop.closed ? 0 : 1) < n; ++i) {
    const std::size_t j = (i + 1) % n;
    if (good[i] && good[j] && dot(s[j].beta - s[i].beta, s[j].x - s[i].x) < 0)
      folded[i] = folded[j] = 1;
  }
  for (std::size_t i = 0; i < n; ++i) good[i] &= !folded[i];
}

void require_room(const std::vector<Roll>& rolls, const std::string& start) {
  const auto off = std::count(rolls.begin(), rolls.end(), Roll::off_cloud);
  if (off > 0) throw NoRoomOnCloud(static_cast<std::size_t>(off));
  if (std::find(rolls.begin(), rolls.end(), Roll::off_face) != rolls.end())
    throw NoResultError(
        "the collar is wider than the face it runs on: the ball does not come to "
        "rest before " +
        start + "; take a smaller radius, or start farther away");
}

}  // namespace

BetaReport roll_ball(const Isolines& isolines, const CloudSide& cloud, BorderLoop& loop,
                     const Job& job) {
  std::vector<Strand>& strands = loop.strands;
  std::vector<Roll> rolls(strands.size());
  parallel_for(job, "rolling ball", strands.size(), grain, [&](std::size_t begin, std::size_t end) {
    MlsScratch scratch;
    Ball ball(isolines, cloud, loop.side, scratch);
    for (std::size_t i = begin; i < end; ++i) rolls[i] = ball.run(strands[i]);
  });
  require_room(rolls, isolines.start().name);
  std::vector<char> good(strands.size());
  for (std::size_t i = 0; i < good.size(); ++i) good[i] = rolls[i] == Roll::touches;
  mark_folds(loop, good);
  const auto bad = static_cast<double>(std::count(good.begin(), good.end(), 0));
  if (bad > most_patched * static_cast<double>(strands.size()))
    throw NoResultError(
        "the collar finds no room on the cloud: its corner is narrower than the "
        "ball; take a smaller radius");
  const std::size_t patched = patch_strands(isolines, cloud, good, loop);
  point_across(loop);
  for (Strand& s : strands) {
    s.height = distance(s.alpha, s.x);
    s.width = distance(s.beta, s.x);
  }
  return {patched};
}

}  // namespace spigolo
