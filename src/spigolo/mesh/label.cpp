// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/label.cpp
#include "spigolo/mesh/label.h"

#include <algorithm>
#include <numeric>

#include "spigolo/core/parallel.h"
#include "spigolo/core/parity_sets.h"
#include "spigolo/mesh/majority.h"
#include "spigolo/mesh/openness.h"

namespace spigolo {
namespace {

constexpr std::size_t grain = 512;
constexpr std::size_t buckets = 8192;
constexpr double per_bucket = 1.0 / 512;  // of openness
constexpr double most_doubt = 1.0;        // neighbors less alike say nothing about each other
constexpr double longest_neighbor = 2.5;  // [steps]
constexpr int least_majority = 6;         // of votes in a part; smaller ones believe nothing

// Two tetrahedra are on the same side (differ 0) or not (1).
struct Statement {
  std::uint32_t a = no_index, b = no_index;
  std::uint8_t differ = 0;
};

// A tetrahedron beside a crease that lies where the normal of a sample looks, or on the other side.
struct Space {
  std::uint32_t tetrahedron, sample;
  bool above;
};

struct Poles {
  std::uint32_t up = no_index, down = no_index;
};

class Labeller {
 public:
  Labeller(const Delaunay& delaunay, const MeshSamples& samples, const CreaseSides& sides,
           const Job& job)
      : delaunay_(delaunay),
        samples_(samples),
        sides_(sides),
        job_(job),
        sets_(delaunay.tetrahedra().size()),
        parts_(samples.size()) {}

  Labelling run() {
    find_poles();
    for (const Poles& p : poles_)
      if (p.up != no_index) state({p.up, p.down, 1});
    state_neighbors();
    state_facets();
    read_labels();
    form_beliefs();
    return std::move(result_);
  }

 private:
  static std::uint32_t vertex(std::size_t sample) {
    return static_cast<std::uint32_t>(sample) + Delaunay::helpers;
  }

  void state(const Statement& s) {
    if (s.a != no_index && s.b != no_index && !sets_.join(s.a, s.b, s.differ))
      ++result_.contradictions;
  }

  void find_poles() {
    poles_.resize(samples_.size());
    parallel_for(job_, "sides", samples_.size(), grain, [&](std::size_t begin, std::size_t end) {
      std::vector<std::uint32_t> scratch;
      for (std::size_t i = std::max(begin, samples_.on_creases); i < end; ++i) {
        if (!delaunay_.has(vertex(i))) continue;
        delaunay_.star(vertex(i), scratch);
        poles_[i] = {delaunay_.towards(vertex(i), samples_.normal[i], scratch),
                     delaunay_.towards(vertex(i), -samples_.normal[i], scratch)};
      }
    });
  }

  // Neighbors on one sheet look to the same side with their normals, or to opposite ones.
  void of_neighbors(std::size_t i, std::vector<std::uint32_t>& scratch,
                    std::vector<Claim>& out) const {
    delaunay_.star(vertex(i), scratch);
    std::vector<std::uint32_t> neighbors;
    for (const std::uint32_t t : scratch)
      for (const std::uint32_t v : delaunay_.tetrahedra()[t].v)
        if (v > vertex(i)) neighbors.push_back(v - Delaunay::helpers);
    std::sort(neighbors.begin(), neighbors.end());
    neighbors.erase(std::unique(neighbors.begin(), neighbors.end()), neighbors.end());
    for (const std::uint32_t j : neighbors) {
      const Vec3 d = samples_.position[j] - samples_.position[i];
      const double length = norm(d), turn = dot(samples_.normal[i], samples_.normal[j]);
      if (!(length > 0) ||
          length > longest_neighbor * std::max(samples_.length[i], samples_.length[j]))
        continue;
      const double doubt = 1 - std::abs(turn) + std::abs(dot(d, samples_.normal[i])) / length +
                           std::abs(dot(d, samples_.normal[j])) / length;
      if (doubt < most_doubt)
        out.push_back({static_cast<std::uint32_t>(i), j, static_cast<std::uint8_t>(turn <= 0),
                       static_cast<float>(doubt)});
    }
  }

  // Around the middle of a segment: the tetrahedron that a direction square to it enters.
  std::uint32_t beside(const VertexPair& segment, const Vec3& direction,
                       const std::vector<std::uint32_t>& around) const {
    const Vec3 &a = delaunay_.point(vertex(segment[0])), &b = delaunay_.point(vertex(segment[1]));
    const Vec3 t = normalized(b - a);
    std::uint32_t best = no_index;
    double best_margin = -infinity;
    for (const std::uint32_t tet : around) {
      std::array<Vec3, 2> side;
      std::size_t n = 0;
      for (const std::uint32_t v : delaunay_.tetrahedra()[tet].v) {
        if (v == vertex(segment[0]) || v == vertex(segment[1])) continue;
        const Vec3 d = delaunay_.point(v) - a;
        side[n++] = normalized(d - dot(d, t) * t);
      }
      // between the two, no farther from either than they are apart
      const double margin = angle_between(side[0], side[1]) - angle_between(side[0], direction) -
                            angle_between(side[1], direction);
      if (margin > best_margin) best_margin = margin, best = tet;
    }
    return best;
  }

  // The pole of a sheet vertex that looks the way of a direction.
  std::uint32_t pole_towards(std::uint32_t q, const Vec3& direction) const {
    return dot(samples_.normal[q], direction) > 0 ? poles_[q].up : poles_[q].down;
  }

  // The two spaces beside a segment differ, and either is the one its sheets face.
  void state_segments() {
    std::vector<std::uint32_t> around;
    for (std::size_t s = 0; s < samples_.creases.size(); ++s) {
      const SegmentSides& sides = sides_.of_segment[s];
      const VertexPair& segment = samples_.creases[s];
      if (!sides.known || !delaunay_.has(vertex(segment[0]))) continue;
      delaunay_.around(vertex(segment[0]), vertex(segment[1]), around);
      if (around.empty()) continue;
      const std::uint32_t first = beside(segment, sides.into[0], around);
      const std::uint32_t second = beside(segment, sides.into[1], around);
      for (const std::uint32_t q : sides.shown_by) {
        const bool above = dot(samples_.normal[q], sides.into[0]) > 0;
        if (first != no_index) spaces_.push_back({first, q, above});
        if (second != no_index) spaces_.push_back({second, q, !above});
        state({first, pole_towards(q, sides.into[0]), 0});
        state({second, pole_towards(q, sides.into[0]), 1});
      }
    }
  }

  // Each segment says how the sheets beside it lie to each other.
  void claims_of_segments(std::vector<Claim>& claims) const {
    for (const SegmentSides& sides : sides_.of_segment) {
      if (!sides.known) continue;
      const auto [a, b] = sides.shown_by;
      const bool same = (dot(samples_.normal[a], sides.into[0]) > 0) ==
                        (dot(samples_.normal[b], sides.into[0]) > 0);
      claims.push_back({a, b, static_cast<std::uint8_t>(!same), 0});
    }
  }

  std::vector<Claim> find_claims() const {
    std::vector<std::vector<Claim>> found(samples_.size() / grain + 1);
    parallel_for(job_, "", samples_.size(), grain, [&](std::size_t begin, std::size_t end) {
      std::vector<std::uint32_t> scratch;
      for (std::size_t i = std::max(begin, samples_.on_creases); i < end; ++i)
        if (delaunay_.has(vertex(i))) of_neighbors(i, scratch, found[begin / grain]);
    });
    std::vector<Claim> all;
    for (const auto& list : found) all.insert(all.end(), list.begin(), list.end());
    claims_of_segments(all);
    return all;
  }

  // Which way the samples look is settled; then it is stated, along the claims that agree.
  void state_neighbors() {
    std::vector<Claim> claims = find_claims();
    sign_ = settle_by_majority(claims, samples_.size());
    std::stable_sort(claims.begin(), claims.end(),
                     [](const Claim& x, const Claim& y) { return x.doubt < y.doubt; });
    for (const auto& [a, b, differ, doubt] : claims)
      if ((sign_[a] ^ sign_[b]) == differ) {
        parts_.join(a, b);
        state({poles_[a].up, poles_[b].up, differ});
      } else {
        ++result_.contradictions;
      }
    state_segments();
  }

  // Of each part of the samples, whether those with sign 0 have the inside above: by majority.
  std::vector<int> inside_above() {
    std::vector<int> votes(samples_.size(), 0);
    for (std::uint32_t i = 0; i < samples_.size(); ++i)
      if (poles_[i].up != no_index)
        for (const std::uint8_t above :
             {result_.inside[poles_[i].up],
              static_cast<std::uint8_t>(1 ^ result_.inside[poles_[i].down])})
          votes[parts_.find(i).set] += (above ^ sign_[i]) != 0 ? 1 : -1;
    return votes;
  }

  void form_beliefs() {
    const std::vector<int> votes = inside_above();
    std::vector<std::uint8_t> above(samples_.size(), 2);  // 2: not known
    for (std::uint32_t i = 0; i < samples_.size(); ++i) {
      const int part = votes[parts_.find(i).set];
      if (poles_[i].up == no_index || std::abs(part) < least_majority) continue;
      above[i] = static_cast<std::uint8_t>(part > 0) ^ sign_[i];
      result_.beliefs.push_back({poles_[i].up, above[i]});
      result_.beliefs.push_back({poles_[i].down, static_cast<std::uint8_t>(1 ^ above[i])});
    }
    for (const auto& [space, sample, same_way] : spaces_)
      if (above[sample] != 2)
        result_.beliefs.push_back(
            {space, static_cast<std::uint8_t>(above[sample] ^ (same_way ? 0 : 1))});
  }

  // Counting sort by openness: bucket, then tetrahedron.
  void state_facets() {
    const auto tets = delaunay_.tetrahedra();
    const Openness openness(delaunay_, samples_, sides_);
    std::vector<std::uint16_t> bucket(4 * tets.size(), 0);
    parallel_for(job_, "openness", tets.size(), grain, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t)
        for (std::size_t i = 0; i < 4 && tets[t].alive(); ++i) {
          if (tets[t].neighbor[i] == no_index || tets[t].neighbor[i] < t) continue;
          const double o = openness.of(static_cast<std::uint32_t>(t), i) / per_bucket;
          bucket[4 * t + i] = static_cast<std::uint16_t>(
              1 + static_cast<std::size_t>(std::clamp(o, 0.0, double{buckets} - 1)));
        }
    });
    std::vector<std::size_t> begin(buckets + 2, 0);
    for (const std::uint16_t b : bucket) ++begin[b];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<std::uint32_t> sorted(bucket.size());
    for (std::size_t f = bucket.size(); f-- > 0;)
      sorted[--begin[bucket[f]]] = static_cast<std::uint32_t>(f);
    for (std::size_t i = sorted.size(); i-- > 0;) {
      const std::uint32_t f = sorted[i];
      if (bucket[f] > 0) state({f / 4, tets[f / 4].neighbor[f % 4], 0});
    }
  }

  // At the helpers: most of these are outside, all unless the surface is open.
  bool endless(std::uint32_t t) const {
    const auto& v = delaunay_.tetrahedra()[t].v;
    return *std::min_element(v.begin(), v.end()) < Delaunay::helpers;
  }

  void read_labels() {
    const auto tets = delaunay_.tetrahedra();
    result_.inside.assign(tets.size(), 0);
    std::size_t count[2] = {0, 0};
    for (std::uint32_t t = 0; t < tets.size(); ++t)
      if (tets[t].alive() && endless(t)) ++count[sets_.find(t).parity];
    const std::uint8_t parity = count[1] > count[0];
    for (std::uint32_t t = 0; t < tets.size(); ++t)
      if (tets[t].alive()) result_.inside[t] = sets_.find(t).parity ^ parity;
  }

  const Delaunay& delaunay_;
  const MeshSamples& samples_;
  const CreaseSides& sides_;
  const Job& job_;
  ParitySets sets_;
  std::vector<Poles> poles_;        // per sample; of those on creases empty
  std::vector<std::uint8_t> sign_;  // per sample: of equal signs, normals look to the same side
  ParitySets parts_;                // of samples whose signs are related
  std::vector<Space> spaces_;
  Labelling result_;
};

}  // namespace

Labelling label_tetrahedra(const Delaunay& delaunay, const MeshSamples& samples,
                           const CreaseSides& sides, const Job& job) {
  return Labeller(delaunay, samples, sides, job).run();
}

}  // namespace spigolo
