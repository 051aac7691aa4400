// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/go_on.cpp
#include "spigolo/trace/go_on.h"

#include <algorithm>
#include <map>

#include "spigolo/core/parallel.h"
#include "spigolo/trace/known_samples.h"
#include "spigolo/trace/place_grid.h"

namespace spigolo {
namespace {

constexpr double least_apart = 0.3;     // [spacings] places of a guide
constexpr double doubtful_end = 10;     // [spacings] of a curve that may be wrong
constexpr double least_left = 3;        // [spacings] of a curve that is cut back
constexpr double short_cut = 6;         // [spacings] a curve that may cut off a corner
constexpr double form_reach = 0.01;     // [spacings] by chance nothing is so near to a form
constexpr double one_march = 0.8;       // [spacings] marches that come so near have met
constexpr std::size_t least_chain = 3;  // places; shorter chains tell no direction

// Of each junction: how many ends meet there.
std::map<int, int> valences(std::span<const CurveDraft> drafts) {
  std::map<int, int> valence;
  for (const CurveDraft& draft : drafts)
    for (const int j : draft.junction) ++valence[j];
  return valence;
}

// Short curves of which nothing is sure and that make no corner with two others: they cut off the
// corner that their neighbors would meet in.
void drop_short_cuts(std::vector<CurveDraft>& drafts, std::span<const CreaseSample> samples) {
  const std::map<int, int> valence = valences(drafts);
  std::erase_if(drafts, [&](const CurveDraft& draft) {
    const auto meets_two = [&](int j) { return j != no_junction && valence.at(j) > 2; };
    const bool alone = draft.junction[0] == no_junction && draft.junction[1] == no_junction;
    return !alone && !draft.guide.closed && draft.guide.length() < short_cut &&
           !meets_two(draft.junction[0]) && !meets_two(draft.junction[1]) &&
           std::none_of(draft.members.begin(), draft.members.end(),
                        [&](const Member& m) { return samples[m.sample].sure; });
  });
}

// Where only two ends meet they may have strayed from one smooth curve: both are free again.
void dissolve_pairs(std::vector<CurveDraft>& drafts) {
  const std::map<int, int> valence = valences(drafts);
  for (CurveDraft& draft : drafts)
    for (int& j : draft.junction)
      if (valence.at(j) <= 2) j = no_junction;
}

// Whether a place lies on the line or circle that a draft was recognised as.
bool on_form(const CurveDraft& draft, const Vec3& p) {
  if (const auto* line = std::get_if<LineFit>(&draft.form))
    return norm(cross(p - line->place, line->direction)) < form_reach;
  const auto* circle = std::get_if<CircleFit>(&draft.form);
  return circle && circle->distance(p) < form_reach;
}

// Free ends go as far as there are members, sure ones if there are any not far from the end.
void trim_free_ends(CurveDraft& draft, std::span<const CreaseSample> samples) {
  if (draft.guide.closed || draft.members.empty()) return;
  double first = draft.members.front().arc, last = draft.members.back().arc;
  std::vector<double> sure;
  for (const Member& m : draft.members)
    if (samples[m.sample].sure || on_form(draft, samples[m.sample].place)) sure.push_back(m.arc);
  if (sure.size() >= least_chain) {
    if (sure.front() - first < doubtful_end) first = sure.front();
    if (last - sure.back() < doubtful_end) last = sure.back();
  }
  if (last - first < least_left) return;
  Guide& guide = draft.guide;
  std::vector<Vec3> places;
  if (draft.junction[0] == no_junction) places.push_back(guide.at(first));
  for (std::size_t i = 0; i < guide.places.size(); ++i) {
    if (draft.junction[0] == no_junction && guide.arc[i] < first + least_apart) continue;
    if (draft.junction[1] == no_junction && guide.arc[i] > last - least_apart) continue;
    places.push_back(guide.places[i]);
  }
  if (draft.junction[1] == no_junction) places.push_back(guide.at(last));
  if (places.size() < 2) return;
  guide.places = std::move(places);
  measure(guide);
}

std::vector<CreaseSample> sure_ones(std::span<const CreaseSample> samples) {
  std::vector<CreaseSample> sure;
  for (const CreaseSample& s : samples)
    if (s.sure) sure.push_back(s);
  return sure;
}

// As far as all places of a march are sure, without the known one it has come to.
void keep_sure(std::vector<CreaseSample>& seen, const KnownSamples& known, const Vec3& from) {
  const auto stop = std::find_if(seen.begin(), seen.end(), [&](const CreaseSample& s) {
    return !s.sure || known.knows(s, from);
  });
  seen.erase(stop, seen.end());
}

// Of two marches that come together the first one stays.
void stop_at_earlier_marches(std::vector<std::vector<CreaseSample>>& found) {
  std::vector<Vec3> places;
  std::vector<std::size_t> owner;
  for (std::size_t e = 0; e < found.size(); ++e)
    for (const CreaseSample& s : found[e]) places.push_back(s.place), owner.push_back(e);
  const PlaceGrid grid(places, one_march);
  for (std::size_t e = 0; e < found.size(); ++e) {
    const auto stop = std::find_if(found[e].begin(), found[e].end(), [&](const CreaseSample& s) {
      bool taken = false;
      grid.within(s.place, one_march, [&](std::uint32_t k) { taken |= owner[k] < e; });
      return taken;
    });
    found[e].erase(stop, found[e].end());
  }
}

}  // namespace

std::vector<CreaseSample> go_on(const Survey& survey, std::vector<CurveDraft>& drafts,
                                std::span<const CreaseSample> samples, const Job& job) {
  std::vector<Chain> chains;
  drop_short_cuts(drafts, samples);
  dissolve_pairs(drafts);
  for (CurveDraft& draft : drafts) {
    trim_free_ends(draft, samples);
    chains.push_back({draft.guide.places, draft.guide.closed, draft.bridged});
  }
  const std::vector<CreaseSample> sure = sure_ones(samples);
  const KnownSamples known(sure);
  const std::vector<ChainEnd> ends = find_ends(chains, 0);
  std::vector<std::vector<CreaseSample>> found(2 * chains.size());
  parallel_for(job, "trace", ends.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t e = begin; e < end; ++e) {
      const auto side = static_cast<std::size_t>(ends[e].side);
      if (drafts[ends[e].chain].junction[side] != no_junction) continue;
      if (chains[ends[e].chain].places.size() < least_chain) continue;
      auto& seen = found[2 * ends[e].chain + side];
      seen = march_from(survey, ends[e], known);
      keep_sure(seen, known, ends[e].model.place);
    }
  });
  stop_at_earlier_marches(found);
  std::vector<CreaseSample> all;
  for (std::size_t e = 0; e < found.size(); ++e) {
    auto& places = drafts[e / 2].guide.places;
    for (const CreaseSample& s : found[e])
      places.insert(e % 2 == 0 ? places.begin() : places.end(), s.place);
    measure(drafts[e / 2].guide);
    all.insert(all.end(), found[e].begin(), found[e].end());
  }
  return all;
}

}  // namespace spigolo
