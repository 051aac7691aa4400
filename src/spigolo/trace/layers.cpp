// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/layers.cpp - samples, chains, network, final curves
#include "spigolo/trace/layers.h"

#include <algorithm>
#include <cmath>

#include "spigolo/core/parallel.h"
#include "spigolo/trace/chain_end.h"
#include "spigolo/trace/extend.h"
#include "spigolo/trace/go_on.h"
#include "spigolo/trace/junctions.h"
#include "spigolo/trace/open_air.h"
#include "spigolo/trace/place_grid.h"
#include "spigolo/trace/rims.h"

namespace spigolo {
namespace {

constexpr double member_reach = 1;   // [spacings] samples this close belong to a curve
constexpr double least_border = 10;  // [spacings] shorter open ones are gaps between samples
constexpr double left_reach = 0.9;   // [spacings] marks farther from all curves are left over
constexpr int corner_rounds = 3;
constexpr double exact_scatter = 0.03;  // [spacings] with less, samples lie on the crease
constexpr double sure_reach = 1.5;      // [spacings] round a place seen for sure
constexpr double sure_cosine = 0.9;     // of directions along one crease
constexpr int exact_rounds = 2, noisy_rounds = 2;

std::vector<CurveDraft> drafts_of(const RawNetwork& raw) {
  std::vector<CurveDraft> drafts;
  for (const RawCurve& curve : raw.curves)
    drafts.push_back(
        {guide_of(curve, raw.junctions), curve.junction, curve.chain.bridged, {}, {}, {}});
  return drafts;
}

// Which samples belong to each draft, and how it runs by them.
void follow_samples(std::vector<CurveDraft>& drafts, const Layer& layer, const Job& job) {
  std::vector<Guide> guides;
  for (const CurveDraft& draft : drafts) guides.push_back(draft.guide);
  auto members = assign_members(guides, layer.samples, member_reach + 2 * layer.scatter);
  parallel_for(job, "trace", drafts.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      drafts[c].members = std::move(members[c]);
      drafts[c].stations =
          smooth_along(drafts[c].guide, drafts[c].members, layer.samples, layer.tolerances.window);
    }
  });
}

// The samples and what was seen; within reach of a place seen for sure, only what is sure.
std::vector<CreaseSample> prefer_sure(std::span<const CreaseSample> samples,
                                      std::span<const CreaseSample> seen) {
  std::vector<CreaseSample> kept;
  std::vector<Vec3> places;
  for (const CreaseSample& s : seen)
    if (s.sure) kept.push_back(s), places.push_back(s.place);
  const PlaceGrid grid(places, sure_reach);
  const auto add_unsure = [&](const CreaseSample& s) {
    bool spoken_for = false;
    grid.within(s.place, sure_reach, [&](std::uint32_t i) {
      spoken_for |= std::abs(dot(kept[i].direction, s.direction)) > sure_cosine;
    });
    if (!spoken_for) kept.push_back(s);
  };
  for (const CreaseSample& s : samples) add_unsure(s);
  for (const CreaseSample& s : seen)
    if (!s.sure) add_unsure(s);
  return kept;
}

// The guides take the course of their stations, and the corners that of the curves.
void guide_by_stations(std::vector<CurveDraft>& drafts, std::span<const Vec3> junctions) {
  for (CurveDraft& draft : drafts) {
    RawCurve raw{{{}, draft.guide.closed, draft.bridged}, draft.junction, false};
    for (const Station& s : draft.stations) raw.chain.places.push_back(s.place);
    auto& places = raw.chain.places;
    if (draft.junction[1] != no_junction && places.size() > 2) places.pop_back();
    if (draft.junction[0] != no_junction && places.size() > 2) places.erase(places.begin());
    draft.guide = guide_of(raw, junctions);
  }
}

// Each corner where the curves that end there say it is.
void place_corners(std::span<const CurveDraft> drafts, const Layer& layer,
                   std::vector<Vec3>& junctions) {
  std::vector<std::vector<ChainEnd>> ends(junctions.size());
  for (std::size_t c = 0; c < drafts.size(); ++c)
    for (int side = 0; side < 2; ++side) {
      const int j = drafts[c].junction[static_cast<std::size_t>(side)];
      if (j == no_junction) continue;
      ends[static_cast<std::size_t>(j)].push_back(
          {c, side, end_model(drafts[c], side, layer.samples, layer.tolerances), j});
    }
  for (std::size_t j = 0; j < junctions.size(); ++j) {
    std::vector<std::size_t> all(ends[j].size());
    for (std::size_t e = 0; e < all.size(); ++e) all[e] = e;
    Vec3 place = junctions[j];
    for (int round = 0; round < corner_rounds; ++round) place = common_point(ends[j], all, place);
    if (is_finite(place) && distance(place, junctions[j]) < 2 + 3 * layer.scatter)
      junctions[j] = place;
  }
}

void add_to(FeatureCurves& network, std::span<const Vec3> junctions,
            std::vector<FeatureCurve> curves) {
  const auto base = static_cast<std::int32_t>(network.corners.size());
  for (const Vec3& place : junctions) network.corners.push_back({place, 0});
  for (FeatureCurve& curve : curves) {
    for (std::int32_t& corner : curve.corner) {
      if (corner == no_corner) continue;
      corner += base;
      ++network.corners[static_cast<std::size_t>(corner)].valence;
    }
    network.curves.push_back(std::move(curve));
  }
}

void recognize_all(std::vector<CurveDraft>& drafts, const Layer& layer, const Job& job) {
  parallel_for(job, "trace", drafts.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) recognize(drafts[c], layer.samples, layer.tolerances);
  });
}

std::vector<FeatureCurve> finish_all(std::span<const CurveDraft> drafts,
                                     std::span<const Vec3> junctions, const Layer& layer,
                                     const Job& job) {
  std::vector<FeatureCurve> curves(drafts.size());
  parallel_for(job, "trace", drafts.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      curves[c] = finish(drafts[c], junctions, layer.samples, layer.tolerances);
      curves[c].kind = layer.kind;
      if (layer.kind == CurveKind::edge) continue;
      std::fill(curves[c].angle.begin(), curves[c].angle.end(), 0.0);
      curves[c].convex = 0;
    }
  });
  return curves;
}

std::vector<Vec3> joined(std::span<const Vec3> a, std::span<const Vec3> b) {
  std::vector<Vec3> all(a.begin(), a.end());
  all.insert(all.end(), b.begin(), b.end());
  return all;
}

std::vector<Vec3> junctions_in_use(std::span<const CurveDraft> drafts,
                                   std::span<const Vec3> junctions) {
  std::vector<char> used(junctions.size(), 0);
  for (const CurveDraft& draft : drafts)
    for (const int j : draft.junction)
      if (j != no_junction) used[static_cast<std::size_t>(j)] = 1;
  std::vector<Vec3> places;
  for (std::size_t j = 0; j < junctions.size(); ++j)
    if (used[j]) places.push_back(junctions[j]);
  return places;
}

// Marks that lie near no curve yet.
std::vector<CreaseSample> left_over(std::span<const CreaseSample> marks,
                                    const FeatureCurves& network) {
  std::vector<Vec3> places;
  for (const FeatureCurve& curve : network.curves)
    places.insert(places.end(), curve.points.begin(), curve.points.end());
  const PlaceGrid grid(places, left_reach);
  std::vector<CreaseSample> left;
  for (const CreaseSample& m : marks)
    if (grid.nearest(m.place, left_reach) == PlaceGrid::no_place) left.push_back(m);
  return left;
}

}  // namespace

// The cloud is asked where chains go on, and again along the curves: for what lies between the
// samples, or with noise for all of it, since what single points saw of the crease is biased.
void trace_edges(Layer layer, const Survey& survey, std::span<const Vec3> hints, const Job& job,
                 FeatureCurves& network) {
  const auto extend = [&](std::vector<CreaseSample> more) {
    layer.samples.insert(layer.samples.end(), more.begin(), more.end());
  };
  std::vector<Chain> chains = link_samples(layer.samples, layer.scatter);
  extend(march_from_ends(survey, chains, layer.samples, layer.scatter, job));
  chains = link_samples(layer.samples, layer.scatter);
  RawNetwork raw = join_chains(std::move(chains), hints, layer.scatter);
  std::vector<CurveDraft> drafts = drafts_of(raw);
  follow_samples(drafts, layer, job);
  const bool exact = layer.scatter < exact_scatter;
  for (int round = 0; round < (exact ? exact_rounds : noisy_rounds); ++round) {
    std::vector<CreaseSample> seen = walk_along(survey, drafts, layer.samples, true, job);
    if (exact)
      layer.samples = prefer_sure(layer.samples, seen);
    else if (round == 0)
      extend(std::move(seen));
    else
      layer.samples = std::move(seen);
    follow_samples(drafts, layer, job);
    recognize_all(drafts, layer, job);
    place_corners(drafts, layer, raw.junctions);
    guide_by_stations(drafts, raw.junctions);
    follow_samples(drafts, layer, job);
  }
  if (exact) {
    extend(go_on(survey, drafts, layer.samples, job));
    follow_samples(drafts, layer, job);
  }
  recognize_all(drafts, layer, job);
  raw = join_chains(reach_out(drafts, raw.junctions, layer.scatter),
                    joined(hints, junctions_in_use(drafts, raw.junctions)), layer.scatter);
  cut_open_air(raw, survey, layer.scatter);
  drafts = drafts_of(raw);
  follow_samples(drafts, layer, job);
  recognize_all(drafts, layer, job);
  place_corners(drafts, layer, raw.junctions);
  add_to(network, raw.junctions, finish_all(drafts, raw.junctions, layer, job));
}

void trace_rims(Layer layer, std::span<const CreaseSample> marks, const Survey& survey,
                const Job& job, FeatureCurves& network) {
  layer.samples = left_over(marks, network);
  std::vector<CurveDraft> rims = find_rims(layer.samples, survey, job);
  cut_open_air(rims, survey, layer.samples, layer.tolerances.window);
  add_to(network, {}, finish_all(rims, {}, layer, job));
}

void trace_borders(const Layer& layer, const Job& job, FeatureCurves& network) {
  RawNetwork raw = join_chains(link_samples(layer.samples, layer.scatter), {}, layer.scatter);
  std::erase_if(raw.curves, [](const RawCurve& curve) {
    return !curve.chain.closed && curve.junction[0] == no_junction &&
           curve.junction[1] == no_junction && curve.chain.length() < least_border;
  });
  std::vector<CurveDraft> drafts = drafts_of(raw);
  follow_samples(drafts, layer, job);
  recognize_all(drafts, layer, job);
  place_corners(drafts, layer, raw.junctions);
  add_to(network, raw.junctions, finish_all(drafts, raw.junctions, layer, job));
}

}  // namespace spigolo
