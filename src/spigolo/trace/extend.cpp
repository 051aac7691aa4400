// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/extend.cpp
#include "spigolo/trace/extend.h"

#include <algorithm>
#include <cmath>

#include "spigolo/core/parallel.h"
#include "spigolo/trace/known_samples.h"
#include "spigolo/trace/place_grid.h"

namespace spigolo {
namespace {

constexpr double longest_reach = 12;    // [spacings] along a form beyond an end
constexpr double own_share = 0.6;       // of its own length that a curve reaches beyond it
constexpr double exact_scatter = 0.03;  // [spacings] with less, forms are exact
constexpr double exact_reach = 20, exact_share = 1.2;  // and lead so far to junctions
constexpr double path_step = 0.5;                      // [spacings]
constexpr double plain_reach = 4.5;                    // [spacings] more is marked as bridged
constexpr std::size_t least_chain = 3;                 // places; shorter chains tell no direction

// Beyond an end: all places lead to junctions, the first ones to other ends, too.
struct Path {
  std::vector<Vec3> places;
  std::size_t plain = 0;
};

// Places half a spacing apart along the form of a draft, beyond one of its ends.
Path path_beyond(const CurveDraft& draft, int side, double scatter) {
  const auto& places = draft.guide.places;
  const Vec3 end = side == 0 ? places.front() : places.back();
  const double length = draft.guide.length();
  const Vec3 outward = draft.guide.direction(side == 0 ? 0 : length) * (side == 0 ? -1.0 : 1.0);
  const double plain = std::min(longest_reach, own_share * length) / path_step;
  const double steps =
      scatter < exact_scatter ? std::min(exact_reach, exact_share * length) / path_step : plain;
  Path beyond{{}, static_cast<std::size_t>(plain)};
  auto& path = beyond.places;
  if (const auto* line = std::get_if<LineFit>(&draft.form)) {
    const Vec3 d = line->direction * (dot(line->direction, outward) < 0 ? -1.0 : 1.0);
    const Vec3 from = line->place + d * dot(end - line->place, d);
    for (double k = 1; k <= steps; ++k) path.push_back(from + d * (k * path_step));
  } else if (const auto* circle = std::get_if<CircleFit>(&draft.form)) {
    const Vec3 x = normalized(circle->nearest(end) - circle->center);
    Vec3 y = cross(circle->axis, x);
    if (dot(y, outward) < 0) y = -y;
    for (double k = 1; k <= steps; ++k) {
      const double a = k * path_step / circle->radius;
      path.push_back(circle->center + (x * std::cos(a) + y * std::sin(a)) * circle->radius);
    }
  }
  return beyond;
}

// What free ends may come to.
struct Target {
  Vec3 place;
  std::size_t owner;  // 2 * draft + side of a free end; own_of_nobody for junctions
  std::size_t steps;  // of its owner's path to get there
  Vec3 outward;       // of free ends
  std::size_t ahead;  // places of the path of a free end
};
constexpr std::size_t own_of_nobody = static_cast<std::size_t>(-1);

// How many places of the path lead to a target, 0 if none does: the first junction or end; else
// where it meets another path soonest for both.
std::size_t steps_to_target(const Path& beyond, const PlaceGrid& grid,
                            std::span<const Target> targets, std::size_t self, double near) {
  const auto& path = beyond.places;
  std::size_t best = 0, least = path.size() * 4;
  for (std::size_t k = 0; k < path.size(); ++k) {
    bool there = false, taken = false;
    const Vec3 going = path[k] - path[k > 0 ? k - 1 : 0];
    grid.within(path[k], near, [&](std::uint32_t t) {
      if (targets[t].owner == self) return;
      if (targets[t].owner != own_of_nobody && k >= beyond.plain) return;
      // Of two ends that face each other one goes on, if it gets so far.
      taken |= targets[t].steps == 0 && targets[t].owner < self && targets[t].ahead >= k &&
               dot(targets[t].outward, going) < -0.8 * norm(going);
      there |= targets[t].steps == 0;
      if (k + targets[t].steps < least) least = k + targets[t].steps, best = k + 1;
    });
    if (there) return taken ? 0 : k + 1;
  }
  return best;
}

std::vector<CreaseSample> joined(std::vector<std::vector<CreaseSample>>& parts) {
  std::vector<CreaseSample> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace

std::vector<Chain> reach_out(std::span<const CurveDraft> drafts, std::span<const Vec3> junctions,
                             double scatter) {
  std::vector<Target> targets;
  for (const Vec3& j : junctions) targets.push_back({j, own_of_nobody, 0, {}, 0});
  std::vector<Path> paths(2 * drafts.size());
  for (std::size_t e = 0; e < paths.size(); ++e) {
    const CurveDraft& draft = drafts[e / 2];
    const auto side = static_cast<int>(e % 2);
    if (draft.guide.closed || draft.junction[e % 2] != no_junction) continue;
    paths[e] = path_beyond(draft, side, scatter);
    const double outward = side == 0 ? -1.0 : 1.0;
    targets.push_back({side == 0 ? draft.guide.places.front() : draft.guide.places.back(), e, 0,
                       draft.guide.direction(side == 0 ? 0 : draft.guide.length()) * outward,
                       paths[e].plain});
    for (std::size_t k = 0; k < std::min(paths[e].plain, paths[e].places.size()); ++k)
      targets.push_back({paths[e].places[k], e, k + 1, {}, 0});
  }
  std::vector<Vec3> places;
  for (const Target& t : targets) places.push_back(t.place);
  const PlaceGrid grid(places, 1);
  const double near = path_step / 2 + 0.1 + scatter;
  std::vector<Chain> chains;
  for (std::size_t c = 0; c < drafts.size(); ++c) {
    const Guide& guide = drafts[c].guide;
    Chain& chain = chains.emplace_back(Chain{guide.places, guide.closed, drafts[c].bridged});
    if (guide.closed) chain.places.pop_back();
    for (std::size_t side = 0; side < 2; ++side) {
      const auto& path = paths[2 * c + side];
      const std::size_t steps = steps_to_target(path, grid, targets, 2 * c + side, near);
      chain.bridged = chain.bridged || static_cast<double>(steps) * path_step > plain_reach;
      for (std::size_t k = 1; k + 1 < steps; k += 2)
        chain.places.insert(side == 0 ? chain.places.begin() : chain.places.end(), path.places[k]);
    }
  }
  return chains;
}

std::vector<CreaseSample> march_from_ends(const Survey& survey, std::span<const Chain> chains,
                                          std::span<const CreaseSample> samples, double scatter,
                                          const Job& job) {
  const KnownSamples known(samples);
  std::vector<ChainEnd> ends = find_ends(chains, scatter);
  std::erase_if(ends,
                [&](const ChainEnd& end) { return chains[end.chain].places.size() < least_chain; });
  std::vector<std::vector<CreaseSample>> found(ends.size());
  parallel_for(job, "trace", ends.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) found[e] = march_from(survey, ends[e], known);
  });
  return joined(found);
}

std::vector<CreaseSample> walk_along(const Survey& survey, std::span<const CurveDraft> drafts,
                                     std::span<const CreaseSample> samples, bool everywhere,
                                     const Job& job) {
  std::vector<std::vector<CreaseSample>> found(drafts.size());
  parallel_for(job, "trace", drafts.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      const WalkOptions options{
          everywhere, {drafts[c].junction[0] != no_junction, drafts[c].junction[1] != no_junction}};
      found[c] = walk(survey, drafts[c].guide, drafts[c].members, samples, options);
    }
  });
  return joined(found);
}

}  // namespace spigolo
