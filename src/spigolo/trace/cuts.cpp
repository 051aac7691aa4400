// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/trace/cuts.cpp - an end on the side of another chain; a chain that passes a junction
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "spigolo/trace/junctions.h"
#include "spigolo/trace/place_grid.h"

namespace spigolo {
namespace {

constexpr double side_step = 0.5;      // [spacings] between the places a chain's side is known by
constexpr double end_reach = 4;        // [spacings] an end looks ahead for a side
constexpr double end_overshoot = 1.5;  // and back
constexpr double noisy_overshoot = 4;  // [scatters] more where samples scatter ...
constexpr double noisy_join = 2;       // [scatters] ... and round a junction
constexpr double own_length = 6;       // [spacings] of its own chain that an end does not run onto
constexpr double pass_reach = 0.4;     // [spacings] a chain that near a junction runs through it
constexpr double join_reach = 1;       // [spacings] an end that near a junction belongs to it
constexpr double clear = 0.4;          // [spacings] places that near a junction stand for it

struct SidePlace {
  Vec3 place;
  std::size_t chain;
  double arc;  // [spacings] from the chain's first place
};

struct Cut {
  double arc;
  int junction;
};

class Cutter {
 public:
  Cutter(std::vector<Chain> chains, std::vector<ChainEnd> ends, std::vector<Vec3> junctions,
         double scatter)
      : chains_(std::move(chains)),
        ends_(std::move(ends)),
        scatter_(scatter),
        sides_(sides_of(chains_)),
        grid_(places_of(sides_), 1),
        cuts_(chains_.size()),
        end_junction_(chains_.size(), {no_junction, no_junction}),
        junction_grid_(junctions, end_reach) {
    network_.junctions = std::move(junctions);
    for (const ChainEnd& end : ends_)
      end_junction_[end.chain][static_cast<std::size_t>(end.side)] = end.junction;
  }

  RawNetwork run() {
    for (std::size_t j = 0; j < network_.junctions.size(); ++j) cut_passing(static_cast<int>(j));
    for (ChainEnd& end : ends_)
      if (end.junction == no_junction) run_onto_side(end);
    for (std::size_t c = 0; c < chains_.size(); ++c) take_apart(c);
    return std::move(network_);
  }

 private:
  static std::vector<SidePlace> sides_of(const std::vector<Chain>& chains) {
    std::vector<SidePlace> sides;
    for (std::size_t c = 0; c < chains.size(); ++c) {
      const auto& places = chains[c].places;
      const std::size_t segments = places.size() - (chains[c].closed ? 0 : 1);
      double arc = 0;
      for (std::size_t i = 0; i < segments; ++i) {
        const Vec3 d = places[(i + 1) % places.size()] - places[i];
        const double length = norm(d);
        const double pieces = std::max(1.0, std::ceil(length / side_step));
        for (double k = 0; k < pieces; ++k)
          sides.push_back({places[i] + d * (k / pieces), c, arc + length * (k / pieces)});
        arc += length;
      }
      if (!chains[c].closed) sides.push_back({places.back(), c, arc});
    }
    return sides;
  }

  static std::vector<Vec3> places_of(const std::vector<SidePlace>& sides) {
    std::vector<Vec3> places;
    for (const SidePlace& side : sides) places.push_back(side.place);
    return places;
  }

  // [spacings] along the chain between two of its places.
  double along(std::size_t chain, double a, double b) const {
    const double d = std::abs(a - b);
    return chains_[chain].closed ? std::min(d, chains_[chain].length() - d) : d;
  }

  bool known(std::size_t chain, double arc, int junction) const {
    for (const Cut& cut : cuts_[chain])
      if (cut.junction == junction || along(chain, cut.arc, arc) < 1) return true;
    for (std::size_t side = 0; side < 2 && !chains_[chain].closed; ++side) {
      const double at = side == 0 ? 0 : chains_[chain].length();
      if (along(chain, at, arc) < (end_junction_[chain][side] == junction ? 2.5 : 0.5)) return true;
    }
    return false;
  }

  // Every chain whose side runs through a junction is cut there.
  void cut_passing(int junction) {
    const Vec3 place = network_.junctions[static_cast<std::size_t>(junction)];
    std::vector<std::uint32_t> near;
    grid_.within(place, pass_reach + scatter_, [&](std::uint32_t s) { near.push_back(s); });
    std::sort(near.begin(), near.end(), [&](std::uint32_t a, std::uint32_t b) {
      return squared_distance(sides_[a].place, place) < squared_distance(sides_[b].place, place);
    });
    for (const std::uint32_t s : near)
      if (!known(sides_[s].chain, sides_[s].arc, junction))
        cuts_[sides_[s].chain].push_back({sides_[s].arc, junction});
  }

  // The first side place that the end runs onto.
  std::optional<SidePlace> hit(const ChainEnd& end) const {
    const double own = end.side == 0 ? 0 : chains_[end.chain].length();
    for (double u = -end_overshoot; u <= end_reach; u += side_step / 2) {
      const Vec3 at = end.model.at(u);
      double least = meeting_tolerance(u, scatter_) + side_step / 2;
      std::optional<SidePlace> best;
      grid_.within(at, least, [&](std::uint32_t s) {
        const SidePlace& side = sides_[s];
        if (side.chain == end.chain && along(end.chain, side.arc, own) < own_length) return;
        const double off = distance(side.place, at);
        if (off < least) least = off, best = side;
      });
      if (best) return best;
    }
    return std::nullopt;
  }

  // The nearest junction that an end passes close by.
  int junction_ahead(const ChainEnd& end) const {
    int best = no_junction;
    double least = infinity;
    junction_grid_.within(end.model.place, end_reach + 1, [&](std::uint32_t j) {
      const Passing p = passing(end, network_.junctions[j]);
      const double back = end_overshoot + noisy_overshoot * scatter_;
      if (p.u < -back || p.u > end_reach || p.distance >= least) return;
      const double round = join_reach + noisy_join * scatter_;
      if (p.distance > round && p.distance > 2 * meeting_tolerance(p.u, scatter_)) return;
      least = p.distance;
      best = static_cast<int>(j);
    });
    return best;
  }

  int cut_near(const SidePlace& side) const {
    for (const Cut& cut : cuts_[side.chain])
      if (along(side.chain, cut.arc, side.arc) < join_reach) return cut.junction;
    return no_junction;
  }

  void run_onto_side(ChainEnd& end) {
    end.junction = junction_ahead(end);
    if (end.junction == no_junction) {
      const auto side = hit(end);
      if (!side) return;
      end.junction = cut_near(*side);
      if (end.junction == no_junction) {
        end.junction = static_cast<int>(network_.junctions.size());
        network_.junctions.push_back(side->place);
        cuts_[side->chain].push_back({side->arc, end.junction});
      }
    }
    end_junction_[end.chain][static_cast<std::size_t>(end.side)] = end.junction;
  }

  // Whether the first of some places says nothing beside the junction they begin at: it is there,
  // or beyond, so that the curve would double back.
  bool stands_for(int junction, std::span<const Vec3> places) const {
    if (junction == no_junction || places.empty()) return false;
    const Vec3 off = places[0] - network_.junctions[static_cast<std::size_t>(junction)];
    return norm(off) < clear || (places.size() > 1 && dot(off, places[1] - places[0]) < 0);
  }

  // Adds one piece, without the places that its junctions stand for.
  void add_piece(RawCurve curve) {
    auto& places = curve.chain.places;
    for (std::size_t side = 0; side < 2; ++side) {
      if (side == 1) std::reverse(places.begin(), places.end());
      std::size_t gone = 0;
      while (stands_for(curve.junction[side], std::span(places).subspan(gone))) ++gone;
      places.erase(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(gone));
      if (side == 1) std::reverse(places.begin(), places.end());
    }
    const bool bounded = curve.junction[0] != no_junction && curve.junction[1] != no_junction;
    const bool loop = curve.junction[0] == curve.junction[1];
    if (places.size() + (bounded && !loop ? 1 : 0) >= (loop && bounded ? 3u : 2u) ||
        (places.size() == 1 && (curve.junction[0] >= 0 || curve.junction[1] >= 0) && !loop))
      network_.curves.push_back(std::move(curve));
  }

  void take_apart(std::size_t c) {
    Chain& chain = chains_[c];
    auto& cuts = cuts_[c];
    std::sort(cuts.begin(), cuts.end(), [](const Cut& a, const Cut& b) { return a.arc < b.arc; });
    if (cuts.empty()) {
      add_piece({std::move(chain), end_junction_[c], false});
      return;
    }
    std::vector<RawCurve> pieces(cuts.size() + 1);
    double arc = 0;
    for (std::size_t i = 0; i < chain.places.size(); ++i) {
      if (i > 0) arc += distance(chain.places[i], chain.places[i - 1]);
      const auto piece =
          std::count_if(cuts.begin(), cuts.end(), [&](const Cut& cut) { return cut.arc <= arc; });
      pieces[static_cast<std::size_t>(piece)].chain.places.push_back(chain.places[i]);
    }
    const std::array<int, 2> outer = end_junction_[c];
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      pieces[p].junction = {p == 0 ? outer[0] : cuts[p - 1].junction,
                            p == cuts.size() ? outer[1] : cuts[p].junction};
      pieces[p].cut = true;
      pieces[p].chain.bridged = chain.bridged;
    }
    if (chain.closed) {  // the last piece goes on with the first
      auto& last = pieces.back().chain.places;
      const auto& first = pieces.front().chain.places;
      last.insert(last.end(), first.begin(), first.end());
      pieces.back().junction[1] = cuts.front().junction;
      pieces.erase(pieces.begin());
    }
    for (RawCurve& piece : pieces) add_piece(std::move(piece));
  }

  std::vector<Chain> chains_;
  std::vector<ChainEnd> ends_;
  double scatter_;
  std::vector<SidePlace> sides_;
  PlaceGrid grid_;
  std::vector<std::vector<Cut>> cuts_;
  std::vector<std::array<int, 2>> end_junction_;  // by chain and side
  PlaceGrid junction_grid_;                       // of those known from the start
  RawNetwork network_;
};

}  // namespace

RawNetwork cut_chains(std::vector<Chain> chains, std::vector<ChainEnd> ends,
                      std::vector<Vec3> junctions, double scatter) {
  return Cutter(std::move(chains), std::move(ends), std::move(junctions), scatter).run();
}

}  // namespace spigolo
