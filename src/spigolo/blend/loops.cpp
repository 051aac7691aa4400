// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/loops.cpp
#include "spigolo/blend/loops.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "spigolo/blend/handles.h"
#include "spigolo/blend/intersect.h"
#include "spigolo/blend/remove.h"
#include "spigolo/blend/rolling_ball.h"
#include "spigolo/blend/widen.h"
#include "spigolo/core/error.h"

namespace spigolo {
namespace {

constexpr double inside_winding = 0.75;  // of a start that lies inside
constexpr int asked_places = 5;          // of a start, whether they lie inside
constexpr double widest_gap = 1;         // [spacings] of alphas or betas, before lines are added
constexpr int most_rounds = 3;
constexpr double shrinking = 0.75;  // of a radius for which the cloud has no room
constexpr int most_shrinkings = 4;
constexpr double least_apart = 3;     // [spacings] betas of two collars
constexpr double least_cross = 1e-7;  // share of the range between two lines

bool lies_inside(const Isolines& isolines, const CloudSide& cloud, const CloudNormals& normals) {
  int inside = 0, asked = 0;
  for (int i = 0; i < asked_places; ++i) {
    const auto line = isolines.line(isolines.range().at((i + 0.5) / asked_places));
    if (!line) continue;
    ++asked;
    const Vec3 p = isolines.at(line->cross, line->begin).point;
    if (std::abs(winding_number(cloud, normals, p)) > inside_winding) ++inside;
  }
  return 2 * inside > asked;
}

bool meets(const Isolines& isolines, const CloudSide& cloud) {
  MlsScratch scratch;
  for (int i = 0; i < asked_places; ++i) {
    const auto line = isolines.line(isolines.range().at((i + 0.5) / asked_places));
    if (!line) continue;
    Strand strand;
    strand.line = *line;
    find_crossing(isolines, cloud, strand, scratch);
    if (strand.crosses) return true;
  }
  return false;
}

std::vector<BlendStart> guess_starts(const NurbsFace& face, const CloudSide& cloud,
                                     const CloudNormals& normals) {
  std::vector<BlendStart> fitting;
  for (const char* name : {"u0", "u1", "v0", "v1"}) {
    const BlendStart start = parse_start(name);
    // A seam is no border.
    if (start.along == Parameter::u ? face.closed_u : face.closed_v) continue;
    const Isolines isolines(face, start);
    if (!lies_inside(isolines, cloud, normals) && meets(isolines, cloud)) fitting.push_back(start);
  }
  if (fitting.size() == 1) return fitting;
  std::string names;
  for (const BlendStart& start : fitting) names += " " + start.name;
  throw NoResultError(fitting.empty()
                          ? "from no border of the face does it meet the cloud from outside: say "
                            "with --start where to begin"
                          : "the face meets the cloud from" + names +
                                ": say with --start which of them to begin at (several are "
                                "allowed)");
}

std::vector<std::size_t> wide_gaps(const TracedStart& t, double widest) {
  const std::vector<Strand>& s = t.loop.strands;
  std::vector<std::size_t> gaps;
  const double range = t.isolines.range().length();
  for (std::size_t i = 0; i + (t.loop.closed ? 0 : 1) < s.size(); ++i) {
    const Strand& next = s[(i + 1) % s.size()];
    double step = next.line.cross - s[i].line.cross;
    if (step < 0) step += range;
    const double gap = std::max(distance(s[i].alpha, next.alpha), distance(s[i].beta, next.beta));
    if (gap > widest && step > least_cross * range) gaps.push_back(i);
  }
  return gaps;
}

std::vector<Vec3> other_curves(const std::vector<TracedStart>& traced, std::size_t but) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < traced.size(); ++i)
    if (i != but)
      for (const Strand& s : traced[i].loop.strands) points.push_back(s.x);
  return points;
}

BetaReport find_borders(const CloudSide& cloud, const Setbacks& setbacks, TracedStart& t,
                        const Job& job) {
  if (setbacks.radius > 0) return roll_ball(t.isolines, cloud, t.loop, job);
  const CollarCurve collar(t.loop);
  find_alphas(t.isolines, collar, t.loop, job);
  return find_betas(cloud, collar, t.loop, job);
}

void trace_one(const CloudSide& cloud, const Setbacks& setbacks, std::span<const Vec3> others,
               TracedStart& t, const Job& job) {
  const double d = cloud.spacing();
  t.loop.widening = 0;
  Widening widening(setbacks.radius);
  for (int round = 0;; ++round) {
    set_directions(t.loop);
    do {
      t.loop.widening = widening.value();
      set_lengths(t.isolines, setbacks, d, others, t.loop);
      t.patched = find_borders(cloud, setbacks, t, job).patched;
    } while (setbacks.radius > 0 && widening.improve(t.loop));
    const std::vector<std::size_t> gaps = wide_gaps(t, widest_gap * d);
    if (gaps.empty() || round == most_rounds) break;
    const std::size_t before = t.loop.strands.size();
    insert_lines(t.isolines, cloud, gaps, t.loop, job);
    if (t.loop.strands.size() == before) break;
  }
  round_handles(cloud.smoothing() * d, t.loop);
}

void require_apart(const std::vector<TracedStart>& traced, double spacing) {
  std::vector<Neighbor> scratch;
  for (std::size_t i = 0; i < traced.size(); ++i)
    for (std::size_t j = i + 1; j < traced.size(); ++j) {
      std::vector<Vec3> betas;
      for (const Strand& s : traced[i].loop.strands) betas.push_back(s.beta);
      const CurveDistance curve(betas, traced[i].loop.closed);
      for (const Strand& s : traced[j].loop.strands)
        if (curve.nearest(s.beta, scratch).distance < least_apart * spacing)
          throw NoResultError("the collars of " + traced[i].isolines.start().name + " and " +
                              traced[j].isolines.start().name +
                              " overlap on the cloud: take a smaller radius or width");
    }
}

}  // namespace

std::vector<BlendStart> choose_starts(const NurbsFace& face, const CloudSide& cloud,
                                      const CloudNormals& normals, const BlendOptions& options,
                                      const Job& job) {
  job.check();
  if (options.starts.empty()) return guess_starts(face, cloud, normals);
  for (const BlendStart& start : options.starts)
    if (lies_inside(Isolines(face, start), cloud, normals))
      throw NoResultError("the start " + start.name +
                          " lies inside the cloud; the blend begins outside: mark another border, "
                          "or an isoline outside like --start v=0.5+");
  return options.starts;
}

std::vector<TracedStart> trace_starts(const NurbsFace& face, const CloudSide& cloud,
                                      const std::vector<BlendStart>& starts,
                                      const BlendOptions& options, const Job& job) {
  std::vector<TracedStart> traced;
  for (const BlendStart& start : starts) {
    TracedStart t{Isolines(face, start), {}, 0, 0};
    t.loop = find_intersection(t.isolines, cloud, t.missed, job);
    set_directions(t.loop);
    t.loop.side = choose_side(cloud, t.loop, options.keep);
    set_directions(t.loop);
    traced.push_back(std::move(t));
  }
  return traced;
}

void trace_borders(const CloudSide& cloud, Setbacks& setbacks, std::vector<TracedStart>& traced,
                   const Job& job) {
  for (int tries = 0;; ++tries) {
    try {
      for (std::size_t i = 0; i < traced.size(); ++i)
        trace_one(cloud, setbacks, other_curves(traced, i), traced[i], job);
      break;
    } catch (const NoRoomOnCloud&) {
      if (!setbacks.chosen || tries == most_shrinkings) throw;
      setbacks.radius *= shrinking;
    }
  }
  require_apart(traced, cloud.spacing());
}

}  // namespace spigolo
