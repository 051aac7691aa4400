// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/intersect.cpp
#include "spigolo/blend/intersect.h"

#include <algorithm>
#include <cmath>

#include "spigolo/core/error.h"
#include "spigolo/core/parallel.h"

namespace spigolo {
namespace {

// All lengths in spacings.
constexpr double near_samples = 3;  // closer to a sample, the MLS surface is asked
constexpr double short_step = 0.15, long_step = 0.5;
constexpr double seed_spacing = 0.5;    // of the lines at the start
constexpr double widest_gap = 0.75;     // of X from line to line, before lines are added
constexpr double jump = 4;              // such a gap that stays is a jump
constexpr double crossing_reach = 2.5;  // a crossing has samples within
constexpr double exactness = 1e-6;
constexpr int most_rounds = 8, most_bisections = 60;
constexpr std::size_t most_steps = 50000, grain = 4;

// The signed distance along one line.
class Walk {
 public:
  Walk(const Isolines& isolines, const CloudSide& cloud, Strand& strand, MlsScratch& scratch)
      : isolines_(isolines), cloud_(cloud), strand_(strand), scratch_(scratch) {}

  void run() {
    const double direction = strand_.line.end > strand_.line.begin ? 1 : -1;
    const double range = std::abs(strand_.line.end - strand_.line.begin);
    double way = 0;
    bool known = false;  // is there a sign to carry on from `last`?
    double last = 0, last_value = 0;
    for (std::size_t i = 0; i < most_steps; ++i) {
      const double at = strand_.line.begin + direction * way;
      const IsoPoint p = isolines_.at(strand_.line.cross, at);
      const double far = cloud_.sample_distance(p.point, scratch_) / cloud_.spacing();
      double value = 0;
      const bool near = far < near_samples && signed_distance(p.point, known, value);
      if (known && near && (value > 0) != (last_value > 0) && bisect(last, last_value, at)) return;
      known = near;
      last = at, last_value = value;
      if (way >= range) return;
      const double length = near ? std::clamp(std::abs(value), short_step, long_step)
                                 : std::max(far - near_samples + long_step, long_step);
      way = std::min(range, way + step_for(p, length, range));
    }
  }

 private:
  // A step of the parameter that goes `length` spacings, but never over much of the line at once.
  double step_for(const IsoPoint& p, double length, double range) const {
    const double speed = norm(p.onward);
    const double step = speed > 0 ? length * cloud_.spacing() / speed : range;
    return std::min(step, range / 64);
  }

  // In spacings; positive where the line first came near. False if there is no surface.
  bool signed_distance(const Vec3& p, bool known, double& value) {
    const SurfacePoint foot = cloud_.project(p, scratch_);
    if (!on_surface(foot.status)) return false;
    const Vec3 off = p - foot.position;
    Vec3 normal = foot.normal;
    if (known ? dot(normal, normal_) < 0 : dot(normal, off) < 0) normal = -normal;
    normal_ = normal;
    value = std::copysign(norm(off), dot(off, normal)) / cloud_.spacing();
    return true;
  }

  bool bisect(double outside, double outside_value, double inside) {
    const Vec3 normal = normal_;
    for (int i = 0; i < most_bisections; ++i) {
      const double middle = (outside + inside) / 2;
      const IsoPoint p = isolines_.at(strand_.line.cross, middle);
      double value = 0;
      normal_ = normal;
      if (!signed_distance(p.point, true, value)) return false;
      if ((value > 0) == (outside_value > 0))
        outside = middle;
      else
        inside = middle;
      if (std::abs(value) < exactness) return accept(middle, p, outside_value);
    }
    return false;  // the sign jumps without a crossing: the foot changed from sheet to sheet
  }

  bool accept(double at, const IsoPoint& p, double outside_value) {
    if (cloud_.sample_distance(p.point, scratch_) > crossing_reach * cloud_.spacing()) return false;
    strand_.crosses = true;
    strand_.at = at;
    strand_.x = p.point;
    strand_.face_normal = p.normal;
    strand_.cloud_normal = outside_value > 0 ? normal_ : -normal_;
    return true;
  }

  const Isolines& isolines_;
  const CloudSide& cloud_;
  Strand& strand_;
  MlsScratch& scratch_;
  Vec3 normal_;  // of the last foot, its sign carried along
};

void cross_all(const Isolines& isolines, const CloudSide& cloud, std::vector<Strand>& strands,
               const Job& job) {
  parallel_for(job, "intersection", strands.size(), grain, [&](std::size_t begin, std::size_t end) {
    MlsScratch scratch;
    for (std::size_t i = begin; i < end; ++i) find_crossing(isolines, cloud, strands[i], scratch);
  });
}

std::vector<Strand> strands_at(const Isolines& isolines, const std::vector<double>& crosses) {
  std::vector<Strand> strands;
  for (const double cross : crosses) {
    Strand strand;
    const auto line = isolines.line(cross);
    strand.line = line ? *line : Isoline{cross, 0, 0};
    strands.push_back(strand);
  }
  return strands;
}

// The longest run of lines that cross; round the end if the family is closed.
BorderLoop longest_run(std::vector<Strand> strands, bool closed) {
  const std::size_t n = strands.size();
  const auto all = std::all_of(strands.begin(), strands.end(), [](auto& s) { return s.crosses; });
  if (all) return {std::move(strands), closed, 1};
  std::size_t best = 0, best_length = 0;
  for (std::size_t start = 0; start < n; ++start) {
    std::size_t length = 0;
    while (length < n && (closed || start + length < n) && strands[(start + length) % n].crosses)
      ++length;
    if (length > best_length) best = start, best_length = length;
  }
  BorderLoop loop;
  for (std::size_t i = 0; i < best_length; ++i) loop.strands.push_back(strands[(best + i) % n]);
  return loop;
}

std::vector<std::size_t> wide_gaps(const BorderLoop& loop, double widest) {
  std::vector<std::size_t> gaps;
  const std::size_t n = loop.strands.size();
  for (std::size_t i = 0; i + (loop.closed ? 0 : 1) < n; ++i)
    if (distance(loop.strands[i].x, loop.strands[(i + 1) % n].x) > widest) gaps.push_back(i);
  return gaps;
}

}  // namespace

void find_crossing(const Isolines& isolines, const CloudSide& cloud, Strand& strand,
                   MlsScratch& scratch) {
  strand.crosses = false;
  if (strand.line.begin != strand.line.end) Walk(isolines, cloud, strand, scratch).run();
}

void insert_lines(const Isolines& isolines, const CloudSide& cloud,
                  const std::vector<std::size_t>& gaps, BorderLoop& loop, const Job& job) {
  std::vector<double> crosses;
  for (const std::size_t i : gaps) {
    const double a = loop.strands[i].line.cross;
    double b = loop.strands[(i + 1) % loop.strands.size()].line.cross;
    if (b < a) b += isolines.range().length();
    crosses.push_back((a + b) / 2);
  }
  std::vector<Strand> added = strands_at(isolines, crosses);
  cross_all(isolines, cloud, added, job);
  std::vector<Strand> merged;
  for (std::size_t i = 0, next = 0; i < loop.strands.size(); ++i) {
    merged.push_back(loop.strands[i]);
    if (next < gaps.size() && gaps[next] == i) {
      if (added[next].crosses) merged.push_back(added[next]);
      ++next;
    }
  }
  loop.strands = std::move(merged);
}

BorderLoop find_intersection(const Isolines& isolines, const CloudSide& cloud, std::size_t& missed,
                             const Job& job) {
  const double d = cloud.spacing();
  std::vector<Strand> strands = strands_at(isolines, isolines.seeds(seed_spacing * d));
  cross_all(isolines, cloud, strands, job);
  const auto met = std::count_if(strands.begin(), strands.end(), [](auto& s) { return s.crosses; });
  missed = strands.size() - static_cast<std::size_t>(met);
  BorderLoop loop = longest_run(std::move(strands), isolines.closed());
  if (loop.strands.size() < 3)
    throw NoResultError("the surfaces do not meet: no line of the face from " +
                        isolines.start().name + " on reaches the cloud's surface");
  for (int round = 0; round < most_rounds; ++round) {
    const std::vector<std::size_t> gaps = wide_gaps(loop, widest_gap * d);
    if (gaps.empty()) break;
    insert_lines(isolines, cloud, gaps, loop, job);
  }
  const std::vector<std::size_t> jumps = wide_gaps(loop, jump * d);
  if (!jumps.empty())
    throw NoResultError("the intersection from " + isolines.start().name +
                        " does not close: it jumps between neighboring lines of the face; the "
                        "cloud has a hole there, or the face leaves it and comes back");
  return loop;
}

}  // namespace spigolo
