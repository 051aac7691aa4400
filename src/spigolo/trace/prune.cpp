// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/prune.cpp - spurs out, curves whole again where only a spur had cut them
#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "spigolo/trace/guide.h"
#include "spigolo/trace/junctions.h"
#include "spigolo/trace/local_fit.h"

namespace spigolo {
namespace {

constexpr double smooth_turn = 0.4;      // [rad] at a junction of two curves that are one
constexpr std::size_t least_places = 4;  // of a curve with a free end
constexpr double companion = 2;          // least lengths of a curve beside another one
constexpr double least_loop = 8;         // [spacings] round a closed curve

bool free_end(const RawCurve& curve, std::size_t side) {
  return !curve.chain.closed && curve.junction[side] == no_junction;
}

bool spur(const RawCurve& curve, double least) {
  const double length = curve.chain.places.size() > 1 ? curve.chain.length() : 0;
  if (curve.chain.closed) return length < least_loop;
  if (curve.junction[0] != no_junction && curve.junction[0] == curve.junction[1])
    return length < 2 * least;
  const int open = free_end(curve, 0) + free_end(curve, 1);
  if (open == 0) return false;
  if (open == 1) return length < 0.8 * least || curve.chain.places.size() < least_places - 1;
  return length < least || curve.chain.places.size() < least_places;
}

// Whether a place lies in the box round a curve, or that near to it.
bool in_box(const RawCurve& curve, const Vec3& p, double near) {
  Vec3 low = curve.chain.places.front(), high = low;
  for (const Vec3& q : curve.chain.places) {
    low = {std::min(low.x, q.x), std::min(low.y, q.y), std::min(low.z, q.z)};
    high = {std::max(high.x, q.x), std::max(high.y, q.y), std::max(high.z, q.z)};
  }
  return p.x > low.x - near && p.y > low.y - near && p.z > low.z - near && p.x < high.x + near &&
         p.y < high.y + near && p.z < high.z + near;
}

// Whether all places of a curve lie that near to the other one.
bool runs_along(const RawCurve& curve, const RawCurve& other, const RawNetwork& network,
                double near) {
  const Guide guide = guide_of(other, network.junctions);
  return std::all_of(curve.chain.places.begin(), curve.chain.places.end(), [&](const Vec3& p) {
    for (double s = 0; s <= guide.length(); s += 0.25)
      if (squared_distance(guide.at(s), p) < near * near) return true;
    return false;
  });
}

// Of two curves between the same junctions that run side by side, the one with fewer places goes.
void drop_doubles(RawNetwork& network, double near) {
  std::map<std::array<int, 2>, std::vector<std::size_t>> between;
  for (std::size_t c = 0; c < network.curves.size(); ++c) {
    auto ends = network.curves[c].junction;
    if (ends[0] > ends[1]) std::swap(ends[0], ends[1]);
    if (ends[0] != no_junction && ends[0] != ends[1]) between[ends].push_back(c);
  }
  for (const auto& [ends, curves] : between)
    for (std::size_t i = 0; i < curves.size(); ++i)
      for (std::size_t j = i + 1; j < curves.size(); ++j) {
        RawCurve &a = network.curves[curves[i]], &b = network.curves[curves[j]];
        if (a.chain.places.empty() || b.chain.places.empty()) continue;
        const bool a_goes = a.chain.places.size() < b.chain.places.size();
        if (runs_along(a_goes ? a : b, a_goes ? b : a, network, near))
          (a_goes ? a : b).chain.places.clear();
      }
  std::erase_if(network.curves, [](const RawCurve& c) { return c.chain.places.empty(); });
}

// Short curves with two free ends that lie along another one, as pieces of it that strayed do.
void drop_companions(RawNetwork& network, double least, double near) {
  std::vector<std::size_t> gone;
  std::vector<double> length;
  for (const RawCurve& curve : network.curves) length.push_back(curve.chain.length());
  for (std::size_t c = 0; c < network.curves.size(); ++c) {
    const RawCurve& curve = network.curves[c];
    if (!free_end(curve, 0) || !free_end(curve, 1) || length[c] > companion * least) continue;
    const Vec3& place = curve.chain.places.front();
    for (std::size_t o = 0; o < network.curves.size(); ++o) {
      const RawCurve& other = network.curves[o];
      if (o == c || length[o] < length[c]) continue;
      if (!in_box(other, place, least) || !runs_along(curve, other, network, near)) continue;
      gone.push_back(c);
      break;
    }
  }
  for (const std::size_t c : gone) network.curves[c].chain.places.clear();
  std::erase_if(network.curves, [](const RawCurve& c) { return c.chain.places.empty(); });
}

using EndsAt = std::vector<std::vector<std::pair<std::size_t, std::size_t>>>;  // curve, side

EndsAt ends_at_junctions(const RawNetwork& network) {
  EndsAt ends(network.junctions.size());
  for (std::size_t c = 0; c < network.curves.size(); ++c)
    for (std::size_t side = 0; side < 2; ++side) {
      const int j = network.curves[c].junction[side];
      if (j != no_junction) ends[static_cast<std::size_t>(j)].push_back({c, side});
    }
  return ends;
}

// Unit vector from a junction into a curve.
Vec3 into(const RawCurve& curve, std::size_t side, const Vec3& junction) {
  const auto& places = curve.chain.places;
  const std::size_t deep = std::min<std::size_t>(places.size() - 1, 3);
  return normalized((side == 0 ? places[deep] : places[places.size() - 1 - deep]) - junction);
}

// Curve b behind curve a, over the junction at the given sides.
void merge(RawNetwork& network, std::pair<std::size_t, std::size_t> a,
           std::pair<std::size_t, std::size_t> b) {
  RawCurve &first = network.curves[a.first], &second = network.curves[b.first];
  auto& places = first.chain.places;
  if (a.first == b.first) {
    first.chain.closed = places.size() > 2;
    first.junction = {no_junction, no_junction};
    return;
  }
  if (a.second == 0) {
    std::reverse(places.begin(), places.end());
    std::swap(first.junction[0], first.junction[1]);
  }
  auto more = second.chain.places;
  if (b.second == 1) std::reverse(more.begin(), more.end());
  places.insert(places.end(), more.begin(), more.end());
  first.junction[1] = second.junction[1 - b.second];
  first.chain.bridged = first.chain.bridged || second.chain.bridged;
  second.chain.places.clear();
}

// Junctions of one end are none; those of two ends that go on smoothly are taken out, of each curve
// one at a time. True if anything changed.
bool mend(RawNetwork& network) {
  const EndsAt ends = ends_at_junctions(network);
  std::vector<char> merged(network.curves.size(), 0);
  bool changed = false;
  for (std::size_t j = 0; j < ends.size(); ++j) {
    if (ends[j].size() == 1) {
      const auto [c, side] = ends[j].front();
      if (merged[c]) continue;  // its sides are others now
      network.curves[c].junction[side] = no_junction;
      changed = true;
    } else if (ends[j].size() == 2) {
      const auto a = ends[j][0], b = ends[j][1];
      if (merged[a.first] || merged[b.first]) continue;
      const RawCurve &first = network.curves[a.first], &second = network.curves[b.first];
      if (first.chain.places.size() < 2 || second.chain.places.size() < 2) continue;
      const Vec3 in_a = into(first, a.second, network.junctions[j]);
      const Vec3 in_b = into(second, b.second, network.junctions[j]);
      if (angle_between(in_a, -in_b) > smooth_turn) continue;
      merge(network, a, b);
      merged[a.first] = merged[b.first] = 1;
      changed = true;
    }
  }
  std::erase_if(network.curves, [](const RawCurve& c) { return c.chain.places.empty(); });
  return changed;
}

// Two junctions that lie together and that a short curve joins are one corner seen twice, as noise
// does it where an end runs past the corner. The curve goes; the junction of more ends stays.
void unite_corners(RawNetwork& network, double least, double near) {
  const EndsAt ends = ends_at_junctions(network);
  std::vector<int> other(ends.size(), no_junction);  // what a junction has become
  const auto now = [&](int j) {
    while (j != no_junction && other[static_cast<std::size_t>(j)] != no_junction)
      j = other[static_cast<std::size_t>(j)];
    return j;
  };
  const auto count = [&](int j) { return ends[static_cast<std::size_t>(j)].size(); };
  for (RawCurve& curve : network.curves) {
    int stays = now(curve.junction[0]), goes = now(curve.junction[1]);
    if (stays == no_junction || goes == no_junction || stays == goes) continue;
    const Vec3& a = network.junctions[static_cast<std::size_t>(stays)];
    const Vec3& b = network.junctions[static_cast<std::size_t>(goes)];
    if (distance(a, b) > near || guide_of(curve, network.junctions).length() > least) continue;
    if (count(stays) < count(goes)) std::swap(stays, goes);
    curve.chain.places.clear();
    other[static_cast<std::size_t>(goes)] = stays;
  }
  for (RawCurve& curve : network.curves)
    for (int& j : curve.junction) j = now(j);
  std::erase_if(network.curves, [](const RawCurve& c) { return c.chain.places.empty(); });
}

void renumber(RawNetwork& network) {
  std::vector<int> number(network.junctions.size(), no_junction);
  std::vector<Vec3> kept;
  for (RawCurve& curve : network.curves)
    for (int& j : curve.junction) {
      if (j == no_junction) continue;
      int& n = number[static_cast<std::size_t>(j)];
      if (n == no_junction) {
        n = static_cast<int>(kept.size());
        kept.push_back(network.junctions[static_cast<std::size_t>(j)]);
      }
      j = n;
    }
  network.junctions = std::move(kept);
}

}  // namespace

RawNetwork prune(RawNetwork network, double least) {
  unite_corners(network, least, least / 4);
  bool changed = true;  // each change leaves fewer curves or fewer ends at junctions
  for (int round = 0; changed; ++round) {
    const std::size_t before = network.curves.size();
    std::erase_if(network.curves, [&](const RawCurve& c) { return spur(c, least); });
    drop_doubles(network, least / 4);
    if (round == 0) drop_companions(network, least, least / 8);
    changed = mend(network) || network.curves.size() != before;
  }
  renumber(network);
  return network;
}

}  // namespace spigolo
