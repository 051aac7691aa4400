// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/bridges.cpp - ends that face each other across a gap
#include <algorithm>
#include <cmath>
#include <tuple>

#include "spigolo/trace/junctions.h"
#include "spigolo/trace/place_grid.h"

namespace spigolo {
namespace {

constexpr double longest = 10;        // [spacings] of a gap that is closed
constexpr double plain_gap = 4.5;     // [spacings] longer ones are marked as bridged
constexpr double most_turn = 0.35;    // [rad] between the tangents of the two ends
constexpr double miss = 0.25;         // [spacings] an end may pass off the other one
constexpr double miss_slope = 0.05;   // more of it for each spacing of the gap
constexpr double exact_longest = 14;  // [spacings] the same where samples do not scatter
constexpr double fill_step = 1;       // [spacings] between places across an exact gap
constexpr double exact_turn_slope = 0.05;
constexpr double exact_miss_slope = 0.04;  // and the ends meet half way
constexpr double exact_scatter = 0.03;     // [spacings] with less, samples lie on the crease
constexpr double most_share = 1;  // a gap is no longer than so many times the shorter chain

struct Bridge {
  double length;
  std::size_t a, b;  // ends
};

// Whether two ends whose places are exact run into one smooth curve half way between them.
bool meet_half_way(const ChainEnd& a, const ChainEnd& b, double gap) {
  const Vec3 chord = (b.model.place - a.model.place) / gap;
  const Vec3 d = b.model.at(gap / 2) - a.model.at(gap / 2);
  if (norm(d - chord * dot(d, chord)) > miss + exact_miss_slope * gap) return false;
  return dot(a.model.tangent, chord) > 0 && dot(b.model.tangent, chord) < 0 &&
         angle_between(a.model.along(gap / 2), -b.model.along(gap / 2)) <
             most_turn + exact_turn_slope * gap;
}

// Whether each end, going on as it does, meets the other.
bool face_each_other(const ChainEnd& a, const ChainEnd& b, double gap, double scatter) {
  if (scatter < exact_scatter) return meet_half_way(a, b, gap);
  const double limit = miss + 1.5 * scatter + miss_slope * gap;
  const Passing there = passing(a, b.model.place), back = passing(b, a.model.place);
  if (there.u <= 0 || back.u <= 0) return false;
  if (there.distance > limit && back.distance > limit) return false;
  const double turn = angle_between(a.model.along(there.u / 2), -b.model.along(back.u / 2));
  return turn < most_turn && angle_between(a.model.tangent, b.model.place - a.model.place) < 0.8;
}

std::vector<Bridge> find_bridges(std::span<const Chain> chains, std::span<const ChainEnd> ends,
                                 double scatter) {
  std::vector<Vec3> places;
  for (const ChainEnd& end : ends) places.push_back(end.model.place);
  const double farthest = scatter < exact_scatter ? exact_longest : longest;
  const PlaceGrid grid(places, farthest);
  std::vector<Bridge> bridges;
  for (std::size_t a = 0; a < ends.size(); ++a)
    grid.within(places[a], farthest, [&](std::uint32_t b) {
      if (b <= a || ends[a].junction != no_junction || ends[b].junction != no_junction) return;
      const double gap = distance(places[a], places[b]);
      const double shorter =
          std::min(chains[ends[a].chain].length(), chains[ends[b].chain].length());
      if (gap > plain_gap && gap > most_share * shorter) return;
      if (ends[a].chain == ends[b].chain && gap > 0.5 * shorter) return;
      if (face_each_other(ends[a], ends[b], gap, scatter)) bridges.push_back({gap, a, b});
    });
  std::sort(bridges.begin(), bridges.end(), [](const Bridge& x, const Bridge& y) {
    return std::tie(x.length, x.a, x.b) < std::tie(y.length, y.a, y.b);
  });
  return bridges;
}

// Appends the places of a chain, entered at the given side.
void append(Chain& to, const Chain& from, int entered) {
  if (entered == 0)
    to.places.insert(to.places.end(), from.places.begin(), from.places.end());
  else
    to.places.insert(to.places.end(), from.places.rbegin(), from.places.rend());
  to.bridged = to.bridged || from.bridged;
}

struct Partner {
  std::size_t end;
  double gap;
};
constexpr std::size_t nobody = static_cast<std::size_t>(-1);

// Places on the cubic that leads from one end to the other.
void fill(Chain& chain, const ChainEnd& from, const ChainEnd& to, double gap) {
  const CurveEnd a{from.model.place, from.model.tangent}, b{to.model.place, -to.model.tangent};
  const double steps = std::floor(gap / fill_step);
  for (double k = 1; k < steps; ++k) chain.places.push_back(cubic_between(a, b, k / steps));
}

// From one end of a chain through all bridges.
Chain run_through(std::span<const Chain> chains, std::span<const ChainEnd> ends,
                  std::span<const Partner> partner, std::size_t start, std::vector<char>& seen,
                  bool exact) {
  Chain joined;
  std::size_t entry = start;
  while (true) {
    seen[ends[entry].chain] = 1;
    append(joined, chains[ends[entry].chain], ends[entry].side);
    const std::size_t exit = entry ^ 1;  // both ends of a chain stand together
    if (partner[exit].end == nobody) break;
    joined.bridged = joined.bridged || partner[exit].gap > plain_gap;
    entry = partner[exit].end;
    if (exact) fill(joined, ends[exit], ends[entry], partner[exit].gap);
    if (entry == start) {
      joined.closed = joined.places.size() > 2;
      break;
    }
  }
  return joined;
}

}  // namespace

std::vector<Chain> bridge_gaps(std::vector<Chain> chains, std::span<const ChainEnd> ends,
                               double scatter) {
  std::vector<Partner> partner(ends.size(), {nobody, 0});
  for (const Bridge& bridge : find_bridges(chains, ends, scatter)) {
    if (partner[bridge.a].end != nobody || partner[bridge.b].end != nobody) continue;
    partner[bridge.a] = {bridge.b, bridge.length};
    partner[bridge.b] = {bridge.a, bridge.length};
  }
  std::vector<Chain> result;
  std::vector<char> seen(chains.size(), 0);
  const auto collect = [&](std::size_t end) {
    if (!seen[ends[end].chain])
      result.push_back(run_through(chains, ends, partner, end, seen, scatter < exact_scatter));
  };
  for (std::size_t e = 0; e < ends.size(); ++e)
    if (partner[e].end == nobody) collect(e);
  for (std::size_t e = 0; e < ends.size(); ++e) collect(e);
  for (std::size_t c = 0; c < chains.size(); ++c)
    if (chains[c].closed) result.push_back(std::move(chains[c]));
  return result;
}

}  // namespace spigolo
