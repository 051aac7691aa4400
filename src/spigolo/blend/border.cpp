// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/border.cpp
#include "spigolo/blend/border.h"

#include <algorithm>
#include <cmath>

#include "spigolo/blend/handles.h"
#include "spigolo/blend/patch.h"
#include "spigolo/core/parallel.h"

namespace spigolo {
namespace {

constexpr double step_on_line = 0.2, step_on_cloud = 0.5;  // [spacings], or a quarter of the length
constexpr int most_bisections = 40;
constexpr double longest_way = 1.8;    // of the width, that may be walked to get so far from X
constexpr double too_close = 0.9;      // of the width: such a beta is patched
constexpr double off_the_cloud = 2.5;  // [spacings] from the nearest sample
constexpr std::size_t grain = 4;
constexpr double most_patched = 0.5;  // share of the betas

std::vector<Vec3> curve_points(const BorderLoop& loop) {
  std::vector<Vec3> points;
  for (const Strand& s : loop.strands) points.push_back(s.x);
  return points;
}

std::vector<double> lengths(const BorderLoop& loop, double Strand::*which) {
  std::vector<double> values;
  for (const Strand& s : loop.strands) values.push_back(s.*which);
  return values;
}

// How much farther from X a point is than the collar reaches there.
double clearance(const CollarCurve& collar, const std::vector<double>& reach, const Vec3& p,
                 std::vector<Neighbor>& scratch) {
  const CurvePlace place = collar.curve.nearest(p, scratch);
  return place.distance - collar.curve.interpolate(reach, place);
}

void find_alpha(const Isolines& isolines, const CollarCurve& collar, double spacing, Strand& s,
                std::vector<Neighbor>& scratch) {
  const double direction = s.line.begin > s.at ? 1 : -1;
  const double range = std::abs(s.line.begin - s.at);
  const auto free = [&](double way) {
    const Vec3 p = isolines.at(s.line.cross, s.at + direction * way).point;
    return clearance(collar, collar.height, p, scratch) >= 0;
  };
  double inside = 0, outside = range, way = 0;
  while (way < range) {
    const double speed = norm(isolines.at(s.line.cross, s.at + direction * way).onward);
    const double step = speed > 0 ? step_on_line * spacing / speed : range;
    way = std::min(range, way + std::min(step, range / 16));
    if (free(way)) {
      outside = way;
      break;
    }
    inside = way;
  }
  for (int i = 0; i < most_bisections; ++i) {
    const double middle = (inside + outside) / 2;
    (free(middle) ? outside : inside) = middle;
  }
  s.alpha_at = s.at + direction * outside;
  const IsoPoint p = isolines.at(s.line.cross, s.alpha_at);
  s.alpha = p.point;
  s.alpha_normal = p.normal;
}

enum class March : std::uint8_t { arrived, blocked, off };

// Walks on the MLS surface, each step in the tangent plane of the last place and projected.
class CloudMarch {
 public:
  CloudMarch(const CloudSide& cloud, const CollarCurve& collar, MlsScratch& scratch)
      : cloud_(cloud), collar_(collar), scratch_(scratch) {}

  March run(Strand& s) {
    const double step = std::min(step_on_cloud * cloud_.spacing(), s.width / 4);
    Vec3 p = s.x, normal = s.cloud_normal, way = s.toward_cloud;
    double walked = 0;
    while (walked < longest_way * s.width) {
      const Vec3 last = p, last_normal = normal;
      if (!advance(p, normal, way, step)) return March::off;
      walked += step;
      if (clearance(collar_, collar_.width, p, scratch_.found) >= 0) {
        settle_between(last, last_normal, way, step, p, normal);
        s.beta = p;
        s.beta_normal = normal;
        return March::arrived;
      }
    }
    s.beta = p;
    s.beta_normal = normal;
    return March::blocked;
  }

 private:
  // False if the cloud ends.
  bool advance(Vec3& p, Vec3& normal, Vec3& way, double length) {
    const Vec3 next = p + way * length;
    const OrientedFoot foot = orient_foot(cloud_.project(next, scratch_), next, normal);
    if (!foot.found) return false;
    if (cloud_.sample_distance(foot.foot, scratch_) > off_the_cloud * cloud_.spacing())
      return false;
    const Vec3 taken = foot.foot - p;
    normal = foot.normal;
    way = normalized(taken - normal * dot(taken, normal));
    p = foot.foot;
    return way != Vec3{};
  }

  // Halves the last step until it ends on the border.
  void settle_between(const Vec3& from, const Vec3& normal, const Vec3& way, double step, Vec3& p,
                      Vec3& p_normal) {
    const Vec3 ahead = normalized(way - normal * dot(way, normal));
    double inside = 0, outside = step;
    for (int i = 0; i < 20; ++i) {
      const double middle = (inside + outside) / 2;
      const Vec3 q = from + ahead * middle;
      const OrientedFoot foot = orient_foot(cloud_.project(q, scratch_), q, normal);
      if (!foot.found) return;
      const bool out = clearance(collar_, collar_.width, foot.foot, scratch_.found) >= 0;
      if (out) p = foot.foot, p_normal = foot.normal;
      (out ? outside : inside) = middle;
    }
  }

  const CloudSide& cloud_;
  const CollarCurve& collar_;
  MlsScratch& scratch_;
};

}  // namespace

CollarCurve::CollarCurve(const BorderLoop& loop)
    : curve(curve_points(loop), loop.closed),
      height(lengths(loop, &Strand::height)),
      width(lengths(loop, &Strand::width)) {}

void find_alphas(const Isolines& isolines, const CollarCurve& collar, BorderLoop& loop,
                 const Job& job) {
  const double spacing = collar.curve.length() / static_cast<double>(loop.strands.size());
  parallel_for(job, "border on the face", loop.strands.size(), grain,
               [&](std::size_t begin, std::size_t end) {
                 std::vector<Neighbor> scratch;
                 for (std::size_t i = begin; i < end; ++i)
                   find_alpha(isolines, collar, spacing, loop.strands[i], scratch);
               });
}

BetaReport find_betas(const CloudSide& cloud, const CollarCurve& collar, BorderLoop& loop,
                      const Job& job) {
  std::vector<Strand>& strands = loop.strands;
  std::vector<March> ends(strands.size());
  parallel_for(job, "border on the cloud", strands.size(), grain,
               [&](std::size_t begin, std::size_t end) {
                 MlsScratch scratch;
                 CloudMarch march(cloud, collar, scratch);
                 for (std::size_t i = begin; i < end; ++i) ends[i] = march.run(strands[i]);
               });
  const auto off = std::count(ends.begin(), ends.end(), March::off);
  if (off > 0) throw NoRoomOnCloud(static_cast<std::size_t>(off));
  std::vector<char> good(strands.size());
  std::vector<Neighbor> scratch;
  for (std::size_t i = 0; i < strands.size(); ++i) {
    const CurvePlace place = collar.curve.nearest(strands[i].beta, scratch);
    good[i] = ends[i] == March::arrived ||
              place.distance >= too_close * collar.curve.interpolate(collar.width, place);
  }
  const auto bad = static_cast<double>(std::count(good.begin(), good.end(), 0));
  if (bad > most_patched * static_cast<double>(strands.size()))
    throw NoResultError(
        "the collar finds no room on the cloud: it overlaps itself; take a smaller radius or "
        "width");
  const std::size_t patched = patch_betas(cloud, good, loop);
  for (Strand& s : strands) point_to_crossing(s);
  return {patched};
}

}  // namespace spigolo
