// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/strips.cpp
#include "spigolo/mesh/strips.h"

#include <algorithm>
#include <array>

#include "spigolo/core/parallel.h"
#include "spigolo/mesh/point_cells.h"

namespace spigolo {
namespace {

constexpr double reach = 2.6;  // [steps] how far points tell about a crease, as for its sides
constexpr double least_reach = 0.25;         // [steps] those nearer to it tell no direction
constexpr double in_sheet = 0.3;             // sine of the angle between a sheet and the way there
constexpr double beside = 0.8;               // cosine of the way there and the crease
constexpr double widest = 2.4;               // [steps] wider strips show their sheet
constexpr double narrowest = 0.2;            // [steps] narrower ones are one crease seen twice
constexpr double unseen = 1.5;               // [steps] a strip without any point in it is no wider
const double alike = std::cos(radians(30));  // the two creases run along each other
const double least_turn = radians(25);       // of a strip against the sheets beside it
constexpr double overlap = 0.15;             // a foot may lie so much of a segment past its end
constexpr double middle_part = 0.3;          // [widths] from the middle: inside of a strip
constexpr double in_plane = 0.2;             // [widths] off it: not in the strip
constexpr double longest_of_width = 0.9;     // [widths] of a segment: its ball leaves the middle
constexpr int most_halvings = 3;
constexpr double apart = 0.6;  // [of the smaller of step and width] between two feet
constexpr std::size_t grain = 128;

struct Strip {
  SurfaceFoot foot;
  std::size_t partner = 0;  // segment
  double width = 0;
};

// Up to two strips beside a segment.
struct Beside {
  std::array<Strip, 2> strip;
  std::size_t count = 0;
};

struct Facing {
  double width;
  std::size_t segment;
  Vec3 way;  // from the middle of one segment to the other crease
  bool operator<(const Facing& o) const {
    return width != o.width ? width < o.width : segment < o.segment;
  }
};

class StripFinder {
 public:
  StripFinder(const SurfacePoints& surface, const MeshSamples& samples, const Job& job)
      : surface_(surface),
        samples_(samples),
        job_(job),
        feet_(samples.step, surface.points.size()),
        middles_(samples.step, samples.creases.size()) {
    for (const SurfaceFoot& foot : surface.points) feet_.insert(foot.position);
    for (const VertexPair& s : samples.creases) middles_.insert(middle(s));
  }

  std::vector<Beside> run() {
    known_.resize(samples_.creases.size());
    const auto all = [&](const auto& of) {
      parallel_for(job_, "", samples_.creases.size(), grain,
                   [&](std::size_t begin, std::size_t end) {
                     for (std::size_t s = begin; s < end; ++s) of(s);
                   });
    };
    all([&](std::size_t s) { known_[s] = known_sides(s); });
    std::vector<Beside> found(samples_.creases.size());
    all([&](std::size_t s) { found[s] = beside_segment(s); });
    return found;
  }

 private:
  // Directions from a crease into the sheets that points show.
  struct Known {
    std::array<Vec3, 2> along;
    std::size_t count = 0;
    bool leaves(const Vec3& way) const {
      for (std::size_t i = 0; i < count; ++i)
        if (angle_between(way, along[i]) < least_turn) return false;
      return true;
    }
  };

  Vec3 middle(const VertexPair& s) const {
    return (samples_.position[s[0]] + samples_.position[s[1]]) * 0.5;
  }
  Vec3 tangent(const VertexPair& s) const {
    return normalized(samples_.position[s[1]] - samples_.position[s[0]]);
  }

  Known known_sides(std::size_t s) const {
    const Vec3 m = middle(samples_.creases[s]), t = tangent(samples_.creases[s]);
    std::vector<std::pair<double, Vec3>> shown;
    feet_.any_within(m, reach * samples_.step, [&](std::uint32_t i, double squared) {
      const SurfaceFoot& foot = surface_.points[i];
      const Vec3 d = foot.position - m, across = d - dot(d, t) * t;
      const double length = std::sqrt(squared);
      if (foot.valid() && norm(across) >= least_reach * samples_.step &&
          std::abs(dot(d, foot.normal)) <= in_sheet * length &&
          std::abs(dot(d, t)) <= beside * length && std::abs(dot(foot.normal, t)) <= 0.5)
        shown.emplace_back(squared, normalized(across));
      return false;
    });
    std::stable_sort(shown.begin(), shown.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    Known known;
    for (const auto& [squared, way] : shown)
      if (known.count < 2 && known.leaves(way)) known.along[known.count++] = way;
    return known;
  }

  // The creases that run along this one, nearest first.
  std::vector<Facing> facing(std::size_t s) const {
    const VertexPair& segment = samples_.creases[s];
    const Vec3 m = middle(segment), t = tangent(segment);
    std::vector<Facing> found;
    middles_.any_within(m, (widest + 0.5) * samples_.step, [&](std::uint32_t q, double) {
      const auto [a, b] = samples_.creases[q];
      if (q == s || a == segment[0] || a == segment[1] || b == segment[0] || b == segment[1])
        return false;
      const Vec3 &pa = samples_.position[a], d = samples_.position[b] - pa;
      const double length = norm(d), share = dot(m - pa, d) / (length * length);
      if (!(length > 0) || std::abs(dot(d, t)) < alike * length || share < -overlap ||
          share > 1 + overlap)
        return false;
      const Vec3 way = pa + share * d - m;
      const double width = norm(way);
      if (width >= narrowest * samples_.step && width <= widest * samples_.step &&
          std::abs(dot(way, t)) < 0.5 * width)
        found.push_back({width, q, way});
      return false;
    });
    std::sort(found.begin(), found.end());
    return found;
  }

  // Points of the cloud lie in the middle of the strip.
  bool shown_by_points(const Vec3& m, const Vec3& way, const Vec3& normal, double width) const {
    const Vec3 center = m + 0.5 * way;
    return feet_.any_within(center, 1.2 * samples_.step, [&](std::uint32_t i, double) {
      const Vec3 d = surface_.points[i].position - center;
      return std::abs(dot(d, way)) <= middle_part * width * width &&
             std::abs(dot(d, normal)) <= in_plane * width;
    });
  }

  Beside beside_segment(std::size_t s) const {
    Beside result;
    if (known_[s].count >= 2) return result;
    const Vec3 m = middle(samples_.creases[s]), t = tangent(samples_.creases[s]);
    Known taken = known_[s];
    for (const Facing& f : facing(s)) {
      if (taken.count >= 2) break;
      const Vec3 n = normalized(cross(t, f.way));
      if (known_[f.segment].count >= 2 || !taken.leaves(f.way) || !known_[f.segment].leaves(-f.way))
        continue;
      if (f.width > unseen * samples_.step && !shown_by_points(m, f.way, n, f.width)) continue;
      taken.along[taken.count++] = normalized(f.way);
      Strip& strip = result.strip[result.count++];
      strip.foot.position = m + 0.5 * f.way;
      strip.foot.normal = n;
      strip.partner = f.segment;
      strip.width = f.width;
    }
    return result;
  }

  const SurfacePoints& surface_;
  const MeshSamples& samples_;
  const Job& job_;
  PointCells feet_, middles_;
  std::vector<Known> known_;
};

// Segments beside a strip that are too long for its width, on both of its creases.
std::vector<std::size_t> too_long(const std::vector<Beside>& found, const MeshSamples& samples) {
  std::vector<std::size_t> which;
  const auto look = [&](std::size_t s, double width) {
    const auto [a, b] = samples.creases[s];
    if (distance(samples.position[a], samples.position[b]) > longest_of_width * width)
      which.push_back(s);
  };
  for (std::size_t s = 0; s < found.size(); ++s)
    for (std::size_t i = 0; i < found[s].count; ++i) {
      look(s, found[s].strip[i].width);
      look(found[s].strip[i].partner, found[s].strip[i].width);
    }
  std::sort(which.begin(), which.end());
  which.erase(std::unique(which.begin(), which.end()), which.end());
  return which;
}

// Both creases of a strip see it: of two feet near each other one stays.
std::vector<SurfaceFoot> thinned(const std::vector<Beside>& found, double step) {
  std::vector<SurfaceFoot> feet;
  PointCells cells(step, 2 * found.size());
  for (const Beside& strips : found)
    for (std::size_t i = 0; i < strips.count; ++i) {
      const Strip& strip = strips.strip[i];
      const auto any = [](std::uint32_t, double) { return true; };
      if (cells.any_within(strip.foot.position, apart * std::min(step, strip.width), any)) continue;
      cells.insert(strip.foot.position);
      feet.push_back(strip.foot);
    }
  return feet;
}

}  // namespace

std::vector<SurfaceFoot> find_strips(const SurfacePoints& surface, MeshSamples& samples,
                                     const Job& job) {
  for (int round = 0;; ++round) {
    const std::vector<Beside> found = StripFinder(surface, samples, job).run();
    const std::vector<std::size_t> split = too_long(found, samples);
    if (split.empty() || round == most_halvings) return thinned(found, samples.step);
    split_creases(samples, split);
  }
}

}  // namespace spigolo
