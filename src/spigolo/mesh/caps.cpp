// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/caps.cpp
#include "spigolo/mesh/caps.h"

#include <algorithm>

#include "spigolo/mesh/check.h"
#include "spigolo/mesh/patch.h"
#include "spigolo/mesh/trim.h"

namespace spigolo {
namespace {

const double steep = radians(50);  // between sheets and film, along the border: with more ...
constexpr int plate_rounds = 3;
constexpr double widest_plate = 4;     // areas of the film; half a ball has 2
constexpr double least_bending = 0.5;  // ... the sheets must bend on their own by this share of it

const double crease = radians(25);  // triangles that meet so are of two sheets

// What the mesh shows around a hole.
struct Surroundings {
  Beyond beyond;
  std::vector<Vec3> normal;  // per border edge that of the triangle at it
};

class Closer {
 public:
  Closer(TriangleMesh& mesh, const CapOptions& options) : mesh_(mesh), options_(options) {
    const auto& p = mesh.vertices.points;
    for (const BorderLoop& loop : find_border_loops(mesh.triangles, p.size())) {
      if (width(loop) <= options.largest * std::max(1.0, mean_edge(loop) / options.step))
        loops_.push_back(loop);
    }
    table_ = find_edges(p.size(), mesh.triangles);
    for (const MeshEdge& edge : table_.edges) {
      neighbors_.push_back({edge.low, edge.high});
      neighbors_.push_back({edge.high, edge.low});
    }
    std::sort(neighbors_.begin(), neighbors_.end());
  }

  CapReport run(const Job& job) {
    CapReport report;
    const std::size_t triangles = mesh_.triangles.size(), points = mesh_.vertices.points.size();
    std::vector<Cap> caps(loops_.size(), Cap::plate);
    for (int attempt = 0; attempt < 4; ++attempt) {
      mesh_.triangles.resize(triangles);
      mesh_.vertices.points.resize(points);
      report = {};
      owner_.clear();
      for (std::size_t i = 0; i < loops_.size(); ++i) {
        job.check();
        add_cap(loops_[i], caps[i], job);
        owner_.resize(mesh_.triangles.size() - triangles, i);
        count(caps[i], report);
      }
      if (!give_way(triangles, caps, job)) break;
    }
    return report;
  }

 private:
  enum class Cap : std::uint8_t { plate, film, none, too_long };

  static void count(Cap cap, CapReport& report) {
    report.smooth += cap == Cap::plate;
    report.taut += cap == Cap::film;
    report.left += cap == Cap::none || cap == Cap::too_long;
    report.too_long += cap == Cap::too_long;
  }

  // Caps that run into the mesh or each other take the next simpler shape. False if none does.
  bool give_way(std::size_t first, std::vector<Cap>& caps, const Job& job) const {
    if (owner_.empty()) return false;
    std::vector<char> bad(caps.size(), 0);
    for (const auto& pair : find_self_intersections(mesh_.vertices.points, mesh_.triangles, job))
      for (const std::uint32_t t : pair)
        if (t >= first) bad[owner_[t - first]] = 1;
    bool any = false;
    for (std::size_t i = 0; i < caps.size(); ++i) {
      if (!bad[i]) continue;
      caps[i] = caps[i] == Cap::plate ? Cap::film : Cap::none;
      any = true;
    }
    return any;
  }

  double width(const BorderLoop& loop) const {
    Box box;
    for (const std::uint32_t v : loop) box.add(mesh_.vertices.points[v]);
    return norm(box.size());
  }

  double mean_edge(const BorderLoop& loop) const {
    double length = 0;
    for (std::size_t i = 0; i < loop.size(); ++i)
      length += distance(mesh_.vertices.points[loop[i]],
                         mesh_.vertices.points[loop[(i + 1) % loop.size()]]);
    return length / static_cast<double>(loop.size());
  }

  Surroundings look_around(const BorderLoop& loop) const {
    Surroundings around;
    const auto& p = mesh_.vertices.points;
    const std::size_t n = loop.size();
    double turn = 0, way = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const std::uint32_t v = loop[i], next = loop[(i + 1) % n], before = loop[(i + n - 1) % n];
      around.beyond.neighbors.emplace_back();
      auto it = std::lower_bound(neighbors_.begin(), neighbors_.end(), VertexPair{v, 0});
      for (; it != neighbors_.end() && (*it)[0] == v; ++it)
        if ((*it)[1] != next && (*it)[1] != before)
          around.beyond.neighbors.back().push_back(p[(*it)[1]]);
      const std::uint32_t half = table_.of(*table_.find(v, next))[0];
      around.normal.push_back(normal_of(half / 3));
      for (const std::uint32_t side : {next_half(half), next_half(next_half(half))})
        add_turn(side, around.normal.back(), turn, way);
    }
    around.beyond.bending = way > 0 ? turn / way : 0;
    return around;
  }

  // How far the surface turns from one triangle to the next.
  void add_turn(std::uint32_t half, const Vec3& normal, double& turn, double& way) const {
    const Triangle& t = mesh_.triangles[half / 3];
    const MeshEdge* edge = table_.find(t[half % 3], t[(half % 3 + 1) % 3]);
    if (edge->count != 2) return;
    const auto halves = table_.of(*edge);
    const std::uint32_t other = (halves[0] == half ? halves[1] : halves[0]) / 3;
    const double angle = angle_between(normal, normal_of(other));
    if (angle > crease) return;
    const Vec3 d = middle_of(other) - middle_of(half / 3);
    turn += dot(d, normal) < 0 ? angle : -angle;
    way += norm(d);
  }

  Vec3 normal_of(std::uint32_t t) const {
    const auto& p = mesh_.vertices.points;
    const auto [a, b, c] = mesh_.triangles[t];
    return normalized(cross(p[b] - p[a], p[c] - p[a]));
  }
  Vec3 middle_of(std::uint32_t t) const {
    const auto& p = mesh_.vertices.points;
    const auto [a, b, c] = mesh_.triangles[t];
    return (p[a] + p[b] + p[c]) / 3;
  }

  // The border turns from its sheets to the film by more than those bend by themselves.
  static bool ends_steeply(const HolePatch& film, const Surroundings& around) {
    double turn = 0, length = 0;
    for (const Triangle& t : film.triangles)
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t a = t[i], b = t[(i + 1) % 3];
        if (a >= film.border || b != (a + 1) % film.border) continue;
        const auto& p = film.points;
        const double edge = distance(p[a], p[b]);
        turn += edge * angle_between(around.normal[a],
                                     normalized(cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]])));
        length += edge;
      }
    if (!(length > 0) || turn <= steep * length) return false;
    const double radius = length / (2 * pi);
    return std::abs(around.beyond.bending) * radius < least_bending * turn / length;
  }

  // From a film to a plate; as that is wider, it takes more vertices. False if it goes astray.
  bool bend(HolePatch& patch, const Beyond& beyond) const {
    const HolePatch film = patch;
    for (int round = 0; round < plate_rounds; ++round) {
      relax_plate(patch, beyond, options_.step);
      if (!(area(patch) < widest_plate * area(film))) {
        patch = film;
        return false;
      }
      refine(patch, options_.step);
    }
    relax_plate(patch, beyond, options_.step);
    return true;
  }

  // cap: what to try; becomes what was taken.
  void add_cap(const BorderLoop& loop, Cap& cap, const Job& job) {
    if (cap == Cap::none || cap == Cap::too_long) return;
    HolePatch patch;
    auto& p = mesh_.vertices.points;
    for (const std::uint32_t v : loop) patch.points.push_back(p[v]);
    patch.border = loop.size();
    patch.triangles = fill_loop(patch.points, job);
    if (patch.triangles.empty()) {
      cap = Cap::too_long;
      return;
    }
    refine(patch, options_.step);
    relax_film(patch);
    if (cap == Cap::plate) {
      const Surroundings around = look_around(loop);
      cap = !ends_steeply(patch, around) && bend(patch, around.beyond) ? Cap::plate : Cap::film;
    }
    const auto base = static_cast<std::uint32_t>(p.size() - patch.border);
    p.insert(p.end(), patch.points.begin() + static_cast<std::ptrdiff_t>(patch.border),
             patch.points.end());
    for (Triangle t : patch.triangles) {
      for (std::uint32_t& v : t) v = v < patch.border ? loop[v] : base + v;
      mesh_.triangles.push_back(t);
    }
  }

  TriangleMesh& mesh_;
  const CapOptions options_;
  std::vector<BorderLoop> loops_;
  EdgeTable table_;
  std::vector<VertexPair> neighbors_;  // both ways, sorted
  std::vector<std::size_t> owner_;     // loop of each new triangle
};

}  // namespace

CapReport close_smoothly(TriangleMesh& mesh, const CapOptions& options, const Job& job) {
  return Closer(mesh, options).run(job);
}

}  // namespace spigolo
