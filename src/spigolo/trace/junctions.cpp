// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/junctions.cpp - ends that run to a common place
#include "spigolo/trace/junctions.h"

#include <algorithm>
#include <tuple>

#include "spigolo/trace/place_grid.h"

namespace spigolo {
namespace {

constexpr double reach = 5;           // [spacings] from an end to a junction that others confirm
constexpr double plain_reach = 3.5;   // the same where only two ends meet
constexpr double overshoot = 2;       // [spacings] a chain may run past its junction
constexpr double one_place = 0.8;     // [spacings] junctions closer than this are one
constexpr double hint_reach = 1;      // [spacings] hints of one corner lie that close
constexpr double at_hand = 1.5;       // [spacings] an end that near to a place is there
constexpr double smooth_turn = 0.45;  // [rad] two ends that turn less go on, they do not meet

struct Candidate {
  Vec3 place;
  bool hinted = false;
  std::vector<std::size_t> ends;  // that pass it ...
  std::vector<double> u;          // ... and how far they have to go
  double cost = 0;                // how far they have to go and how far off they pass
};

// Middle of each group of hints that lie together, the largest groups first.
std::vector<Vec3> hint_places(std::span<const Vec3> hints) {
  const PlaceGrid grid(hints, hint_reach);
  std::vector<char> used(hints.size(), 0);
  std::vector<Vec3> places;
  for (std::uint32_t i = 0; i < hints.size(); ++i) {
    if (used[i]) continue;
    std::vector<Vec3> group;
    grid.within(hints[i], hint_reach, [&](std::uint32_t j) {
      if (!used[j]) group.push_back(hints[j]);
      used[j] = 1;
    });
    const auto off = [&](const Vec3& p) {
      double sum = 0;
      for (const Vec3& q : group) sum += distance(p, q);
      return sum;
    };
    places.push_back(*std::min_element(
        group.begin(), group.end(), [&](const Vec3& a, const Vec3& b) { return off(a) < off(b); }));
  }
  return places;
}

class JunctionFinder {
 public:
  JunctionFinder(std::vector<ChainEnd>& ends, double scatter)
      : ends_(ends), scatter_(scatter), grid_(places_of(ends), reach) {}

  void add_hints(std::span<const Vec3> hints) {
    for (const Vec3& place : hint_places(hints)) add({place, true, {}, {}, 0});
  }

  void add_meetings() {
    for (std::size_t a = 0; a < ends_.size(); ++a)
      grid_.within(ends_[a].model.place, 2 * reach, [&](std::uint32_t b) {
        if (b <= a) return;
        const auto m = meeting(ends_[a], ends_[b]);
        if (!m || !in_reach(m->u) || !in_reach(m->v)) return;
        if (m->gap <= meeting_tolerance(m->u, scatter_) + meeting_tolerance(m->v, scatter_))
          add({m->place, false, {}, {}, 0});
      });
  }

  // Most ends first, then the nearest.
  std::vector<Vec3> choose(bool sure) {
    std::sort(candidates_.begin(), candidates_.end(), [](const Candidate& a, const Candidate& b) {
      const auto votes = [](const Candidate& c) { return 2 * c.ends.size() + c.hinted; };
      return votes(a) != votes(b) ? votes(a) > votes(b) : a.cost < b.cost;
    });
    find_stops();
    for (std::size_t wanted = most_ends(); wanted >= 2; --wanted)
      for (const Candidate& candidate : candidates_)
        if (candidate.ends.size() >= wanted) try_place(candidate, wanted, sure);
    return std::move(junctions_);
  }

 private:
  static std::vector<Vec3> places_of(const std::vector<ChainEnd>& ends) {
    std::vector<Vec3> places;
    for (const ChainEnd& end : ends) places.push_back(end.model.place);
    return places;
  }
  static bool in_reach(double u) { return u >= -overshoot && u <= reach; }

  void add(Candidate candidate) {
    std::vector<std::uint32_t> near;
    grid_.within(candidate.place, reach + 1, [&](std::uint32_t e) { near.push_back(e); });
    std::sort(near.begin(), near.end());
    for (const std::uint32_t e : near) {
      const Passing p = passing(ends_[e], candidate.place);
      if (!in_reach(p.u) || p.distance > meeting_tolerance(p.u, scatter_)) continue;
      candidate.ends.push_back(e);
      candidate.u.push_back(p.u);
      candidate.cost += std::abs(p.u) + 4 * p.distance;
    }
    if (candidate.ends.size() >= 2) candidates_.push_back(std::move(candidate));
  }

  std::size_t most_ends() const {
    std::size_t most = 0;
    for (const Candidate& c : candidates_) most = std::max(most, c.ends.size());
    return most;
  }

  // Of each end, how far it goes to the first place that two others have all but come to: the
  // corner at this side of a slot's mouth, not the one at the other side.
  void find_stops() {
    stop_.assign(ends_.size(), infinity);
    for (const Candidate& c : candidates_) {
      const auto there =
          std::count_if(c.u.begin(), c.u.end(), [](double u) { return u < at_hand; });
      for (std::size_t i = 0; i < c.ends.size(); ++i)
        if (there - (c.u[i] < at_hand ? 1 : 0) >= 2)
          stop_[c.ends[i]] = std::min(stop_[c.ends[i]], c.u[i]);
    }
  }

  int known_junction(const Vec3& place) const {
    for (std::size_t j = junctions_.size(); j-- > 0;)
      if (distance(junctions_[j], place) < one_place + scatter_) return static_cast<int>(j);
    return no_junction;
  }

  bool two_may_meet(const Candidate& candidate, std::span<const std::size_t> free) const {
    const ChainEnd &a = ends_[free[0]], &b = ends_[free[1]];
    const double u = passing(a, candidate.place).u, v = passing(b, candidate.place).u;
    if (!candidate.hinted && std::max(u, v) > plain_reach + scatter_) return false;
    return angle_between(a.model.along(u), -b.model.along(v)) > smooth_turn;
  }

  void try_place(const Candidate& candidate, std::size_t wanted, bool sure) {
    std::vector<std::size_t> free;
    for (std::size_t i = 0; i < candidate.ends.size(); ++i)
      if (ends_[candidate.ends[i]].junction == no_junction &&
          candidate.u[i] <= stop_[candidate.ends[i]] + one_place + scatter_)
        free.push_back(candidate.ends[i]);
    if (free.empty()) return;
    int junction = known_junction(candidate.place);
    if (junction == no_junction) {
      if (free.size() < wanted || free.size() < 2) return;
      if (sure && free.size() == 2 && !candidate.hinted) return;
      if (free.size() == 2 && !two_may_meet(candidate, free)) return;
      junction = static_cast<int>(junctions_.size());
      junctions_.push_back(common_point(ends_, free, candidate.place));
    }
    for (const std::size_t e : free) ends_[e].junction = junction;
  }

  std::vector<ChainEnd>& ends_;
  double scatter_;
  PlaceGrid grid_;
  std::vector<Candidate> candidates_;
  std::vector<Vec3> junctions_;
  std::vector<double> stop_;  // per end
};

}  // namespace

std::vector<Vec3> find_junctions(std::vector<ChainEnd>& ends, std::span<const Vec3> hints,
                                 double scatter, bool sure) {
  JunctionFinder finder(ends, scatter);
  finder.add_hints(hints);
  finder.add_meetings();
  return finder.choose(sure);
}

RawNetwork join_chains(std::vector<Chain> chains, std::span<const Vec3> hints, double scatter) {
  std::vector<ChainEnd> ends = find_ends(chains, scatter);
  find_junctions(ends, hints, scatter, true);
  chains = bridge_gaps(std::move(chains), ends, scatter);
  ends = find_ends(chains, scatter);
  std::vector<Vec3> junctions = find_junctions(ends, hints, scatter, false);
  RawNetwork network =
      cut_chains(std::move(chains), std::move(ends), std::move(junctions), scatter);
  return prune(std::move(network), least_curve(scatter));
}

}  // namespace spigolo
