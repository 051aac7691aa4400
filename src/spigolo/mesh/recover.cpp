// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/recover.cpp
#include "spigolo/mesh/recover.h"

#include <algorithm>
#include <memory>
#include <tuple>
#include <utility>

#include "spigolo/mesh/triangle_contact.h"
#include "spigolo/mesh/triangle_tree.h"

namespace spigolo {
namespace {

constexpr int most_rounds = 4;
constexpr int most_flips = 4;  // on the way from one end of a segment to the other
const double same_way = std::cos(radians(100));  // a new triangle against those it stands for

class CreaseRecovery {
 public:
  CreaseRecovery(std::vector<Triangle>& triangles, const std::vector<Vec3>& points,
                 std::span<const VertexPair> creases, const Job& job)
      : points_(points), triangles_(triangles) {
    for (const auto& [a, b] : creases) creases_.push_back(pair(a, b));
    std::sort(creases_.begin(), creases_.end());
    find_lost(creases);
    if (!lost_.empty()) prepare(creases, job);
  }

  RecoverReport run() {
    for (int round = 0; round < most_rounds && tree_ && !lost_.empty(); ++round) {
      const RecoverReport before = report_;
      for (const auto& [a, b] : lost_) {
        insert(a), insert(b);
        connect(a, b);
      }
      std::erase_if(lost_, [&](const VertexPair& s) { return is_edge(s[0], s[1]); });
      if (report_.flipped == before.flipped && report_.inserted == before.inserted) break;
    }
    if (!alive_.empty()) keep_alive();
    return report_;
  }

 private:
  static VertexPair pair(std::uint32_t a, std::uint32_t b) {
    return {std::min(a, b), std::max(a, b)};
  }

  void find_lost(std::span<const VertexPair> creases) {
    std::vector<char> on_crease(points_.size(), 0), kept(creases_.size(), 0);
    for (const auto& [a, b] : creases) on_crease[a] = on_crease[b] = 1;
    for (const Triangle& t : triangles_)
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t a = t[i], b = t[(i + 1) % 3];
        if (!on_crease[a] || !on_crease[b]) continue;
        const auto at = std::lower_bound(creases_.begin(), creases_.end(), pair(a, b));
        if (at != creases_.end() && *at == pair(a, b))
          kept[static_cast<std::size_t>(at - creases_.begin())] = 1;
      }
    for (std::size_t s = 0; s < creases_.size(); ++s)
      if (!kept[s] && (s == 0 || creases_[s] != creases_[s - 1])) lost_.push_back(creases_[s]);
  }

  void prepare(std::span<const VertexPair> creases, const Job& job) {
    around_.resize(points_.size());
    on_creases_.resize(points_.size());
    for (const auto& [a, b] : creases) {
      on_creases_[a].push_back(b);
      on_creases_[b].push_back(a);
    }
    for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
      for (const std::uint32_t v : triangles_[t]) around_[v].push_back(t);
      if (sound(triangles_[t])) solid_.push_back(triangles_[t]), number_.push_back(t);
    }
    old_ = triangles_.size();
    alive_.assign(old_, 1);
    if (!solid_.empty()) tree_ = std::make_unique<TriangleTree>(points_, solid_, job);
  }

  bool is_crease(std::uint32_t a, std::uint32_t b) const {
    return std::binary_search(creases_.begin(), creases_.end(), pair(a, b));
  }
  bool is_edge(std::uint32_t a, std::uint32_t b) const {
    return std::any_of(around_[a].begin(), around_[a].end(), [&](std::uint32_t t) {
      return std::find(triangles_[t].begin(), triangles_[t].end(), b) != triangles_[t].end();
    });
  }
  bool used(std::uint32_t v) const { return !around_[v].empty(); }
  bool sound(const Triangle& t) const {
    return !is_degenerate(points_[t[0]], points_[t[1]], points_[t[2]]);
  }
  Vec3 area(const Triangle& t) const {
    return cross(points_[t[1]] - points_[t[0]], points_[t[2]] - points_[t[0]]);
  }

  // The triangle on the left of the half-edge from a to b, and its third corner.
  std::uint32_t left_of(std::uint32_t a, std::uint32_t b) const {
    for (const std::uint32_t t : around_[a])
      for (std::size_t i = 0; i < 3; ++i)
        if (triangles_[t][i] == a && triangles_[t][(i + 1) % 3] == b) return t;
    return no_index;
  }
  std::uint32_t third(std::uint32_t t, std::uint32_t a, std::uint32_t b) const {
    for (const std::uint32_t v : triangles_[t])
      if (v != a && v != b) return v;
    return no_index;
  }

  TrianglePoints corners(const Triangle& t) const {
    return {points_[t[0]], points_[t[1]], points_[t[2]]};
  }
  static Box box_of(const TrianglePoints& p) {
    Box box;
    for (const Vec3& q : p) box.add(q);
    return box;
  }

  // Whether a new triangle runs into one that stays.
  bool runs_into_others(const Triangle& t, const std::vector<std::uint32_t>& going) {
    const TrianglePoints p = corners(t);
    const Box box = box_of(p);
    const auto meets = [&](std::uint32_t other) {
      return alive_[other] && std::find(going.begin(), going.end(), other) == going.end() &&
             sound(triangles_[other]) && run_into_each_other(p, corners(triangles_[other]));
    };
    tree_->overlapping(box, 0, leaves_);
    for (const std::uint32_t l : leaves_)
      for (const std::uint32_t s : tree_->leaf(l))
        if (overlap(tree_->box(s), box) && meets(number_[s])) return true;
    for (std::size_t n = old_; n < triangles_.size(); ++n)
      if (overlap(box_of(corners(triangles_[n])), box) && meets(static_cast<std::uint32_t>(n)))
        return true;
    return false;
  }

  // Puts new triangles in the place of others, unless that makes a fault.
  bool replace(const std::vector<std::uint32_t>& going, const std::vector<Triangle>& coming) {
    Vec3 mean;
    for (const std::uint32_t t : going) mean += area(triangles_[t]);
    mean = normalized(mean);
    for (std::size_t i = 0; i < coming.size(); ++i) {
      if (!sound(coming[i]) || dot(normalized(area(coming[i])), mean) < same_way) return false;
      for (std::size_t j = 0; j < i; ++j)
        if (run_into_each_other(corners(coming[i]), corners(coming[j]))) return false;
    }
    for (const Triangle& t : coming)
      if (runs_into_others(t, going)) return false;
    for (const std::uint32_t t : going) {
      alive_[t] = 0;
      for (const std::uint32_t v : triangles_[t]) std::erase(around_[v], t);
    }
    for (const Triangle& t : coming) {
      for (const std::uint32_t v : t)
        around_[v].push_back(static_cast<std::uint32_t>(triangles_.size()));
      triangles_.push_back(t);
      alive_.push_back(1);
    }
    return true;
  }

  // a vertex into an edge: of the triangles beside it four are made.
  bool split(std::uint32_t x, std::uint32_t y, std::uint32_t v) {
    const std::uint32_t t = left_of(x, y), u = left_of(y, x);
    std::vector<std::uint32_t> going;
    std::vector<Triangle> coming;
    for (const auto& [side, a, b] : {std::tuple{t, x, y}, std::tuple{u, y, x}}) {
      if (side == no_index) continue;
      const std::uint32_t c = third(side, a, b);
      going.push_back(side);
      coming.push_back({a, v, c});
      coming.push_back({v, b, c});
    }
    return !going.empty() && replace(going, coming);
  }

  // A crease vertex off the surface goes into it beside a neighbor on the crease that is there.
  void insert(std::uint32_t v) {
    if (used(v)) return;
    for (const std::uint32_t x : on_creases_[v]) {
      if (!used(x)) continue;
      for (const std::uint32_t y : beyond(v, x))
        if (!is_crease(x, y) && is_edge(x, y) && split(x, y, v)) {
          ++report_.inserted;
          return;
        }
      if (into_triangle(x, v)) {
        ++report_.inserted;
        return;
      }
    }
  }

  // The next vertices of the surface along the crease on the other side of v.
  std::vector<std::uint32_t> beyond(std::uint32_t v, std::uint32_t from) const {
    std::vector<std::uint32_t> found;
    for (std::uint32_t next : on_creases_[v]) {
      std::uint32_t before = v;
      while (next != from && !used(next) && on_creases_[next].size() == 2) {
        const auto& pair = on_creases_[next];
        const std::uint32_t after = pair[0] == before ? pair[1] : pair[0];
        before = std::exchange(next, after);
      }
      if (next != from && used(next)) found.push_back(next);
    }
    return found;
  }

  // Of the triangles at x the one that v lies over, or else the next.
  bool into_triangle(std::uint32_t x, std::uint32_t v) {
    const Vec3 d = points_[v] - points_[x];
    std::vector<std::pair<double, std::uint32_t>> order;
    for (const std::uint32_t t : around_[x]) {
      const Vec3 middle =
          (points_[triangles_[t][0]] + points_[triangles_[t][1]] + points_[triangles_[t][2]]) / 3;
      order.emplace_back(angle_between(d, middle - points_[x]), t);
    }
    std::sort(order.begin(), order.end());
    for (std::size_t i = 0; i < std::min<std::size_t>(2, order.size()); ++i) {
      const std::uint32_t t = order[i].second;
      const auto [a, b, c] = triangles_[t];
      if (replace({t}, {{a, b, v}, {b, c, v}, {c, a, v}})) return true;
    }
    return false;
  }

  // Flips edges that stand between two vertices.
  void connect(std::uint32_t a, std::uint32_t b) {
    if (!used(a) || !used(b)) return;
    for (int step = 0; step < most_flips && !is_edge(a, b); ++step)
      if (!flip_towards(a, b) && !flip_towards(b, a)) return;
  }

  // The edge opposite to a that a segment to b crosses goes.
  bool flip_towards(std::uint32_t a, std::uint32_t b) {
    const Vec3 d = normalized(points_[b] - points_[a]);
    std::uint32_t best = no_index;
    double least = radians(60);
    for (const std::uint32_t t : around_[a]) {
      const auto [c, e] = opposite(t, a);
      const std::uint32_t u = left_of(e, c);
      if (is_crease(c, e) || u == no_index) continue;
      const std::uint32_t apex = third(u, c, e);
      if (apex == a || is_edge(a, apex)) continue;
      const double off = apex == b ? -1 : angle_between(points_[apex] - points_[a], d);
      if (off < least) least = off, best = t;
    }
    if (best == no_index) return false;
    const auto [c, e] = opposite(best, a);
    const std::uint32_t u = left_of(e, c), apex = third(u, c, e);
    if (!replace({best, u}, {{a, c, apex}, {a, apex, e}})) return false;
    ++report_.flipped;
    return true;
  }

  // The corners of a triangle after a.
  std::pair<std::uint32_t, std::uint32_t> opposite(std::uint32_t t, std::uint32_t a) const {
    const Triangle& v = triangles_[t];
    const std::size_t i = v[0] == a ? 0 : v[1] == a ? 1 : 2;
    return {v[(i + 1) % 3], v[(i + 2) % 3]};
  }

  void keep_alive() {
    std::size_t n = 0;
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      if (alive_[t]) triangles_[n++] = triangles_[t];
    triangles_.resize(n);
  }

  const std::vector<Vec3>& points_;
  std::vector<Triangle>& triangles_;
  std::vector<std::vector<std::uint32_t>> around_;      // per vertex, its triangles
  std::vector<std::vector<std::uint32_t>> on_creases_;  // per vertex, its neighbors along creases
  std::vector<VertexPair> creases_, lost_;
  std::vector<char> alive_;
  std::vector<Triangle> solid_;        // what the tree holds
  std::vector<std::uint32_t> number_;  // of each of these, in triangles_
  std::unique_ptr<TriangleTree> tree_;
  std::size_t old_ = 0;  // triangles from here on are new
  std::vector<std::uint32_t> leaves_;
  RecoverReport report_;
};

}  // namespace

RecoverReport recover_creases(std::vector<Triangle>& triangles, const std::vector<Vec3>& points,
                              std::span<const VertexPair> creases, const Job& job) {
  return CreaseRecovery(triangles, points, creases, job).run();
}

}  // namespace spigolo
