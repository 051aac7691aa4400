// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/samples.cpp - sheets thinned to the edge length, their gaps filled
#include "spigolo/mesh/samples.h"

#include <algorithm>
#include <array>
#include <utility>

#include "spigolo/core/parallel.h"
#include "spigolo/mesh/continuation.h"
#include "spigolo/mesh/point_cells.h"
#include "spigolo/mesh/strips.h"

namespace spigolo {
namespace {

constexpr double sheet_distance = 0.7;    // [edges] no two vertices of a sheet are closer
constexpr double crease_distance = 0.62;  // [steps] free of sheet vertices around a crease: keeps
                                          // the ball over each segment, of radius .5, empty
constexpr double sparse = 1.6;  // times the spacing: edges are as long as samples are apart
constexpr double neighbor_distance = 1.6;        // [edges] neighbors farther away leave a gap
const double widest_gap = radians(80);           // between the directions of neighbors
constexpr double candidate_distance = 0.9;       // [edges] from the vertex beside the gap
constexpr double support_radius = 2.6;           // [spacings] surface points must lie in here ...
constexpr std::size_t least_support = 5;         // ... at least so many ...
const double widest_support_gap = radians(140);  // ... and all around
constexpr double strip_reach = 0.75;  // [steps] points that near to the middle of a strip ...
constexpr double strip_depth = 0.25;  // [steps] ... and that near to its plane are in it, ...
constexpr double strip_turn = 0.7;    // cosine: ... but not of it, if their normal turns so far
constexpr int most_rounds = 16;
constexpr std::size_t grain = 1024;

// On one sheet: the step from one to the other does not leave it.
bool same_sheet(const Vec3& p, const Vec3& n, const Vec3& q, const Vec3& m) {
  const Vec3 d = q - p;
  const double across = std::max(std::abs(dot(d, n)), std::abs(dot(d, m)));
  return std::abs(dot(n, m)) > 0.5 && across <= 0.6 * norm(d);
}

// Directions around a place, as angles about its normal.
class Compass {
 public:
  explicit Compass(const Vec3& normal) : x_(any_perpendicular(normal)), y_(cross(normal, x_)) {}
  void add(const Vec3& d) {
    if (count_ < most) angles_[count_++] = std::atan2(dot(d, y_), dot(d, x_));
  }
  std::size_t count() const { return count_; }
  Vec3 direction(double angle) const { return std::cos(angle) * x_ + std::sin(angle) * y_; }

  /// Calls visit(begin, width) for every gap between neighboring directions wider than `least`.
  template <class Visit>
  void gaps(double least, const Visit& visit) {
    std::sort(angles_.begin(), angles_.begin() + static_cast<std::ptrdiff_t>(count_));
    if (count_ == 0) visit(0.0, 2 * pi);
    for (std::size_t i = 0; i < count_; ++i) {
      const double next = i + 1 == count_ ? angles_[0] + 2 * pi : angles_[i + 1];
      if (next - angles_[i] > least) visit(angles_[i], next - angles_[i]);
    }
  }

 private:
  static constexpr std::size_t most = 128;  // more leave no gap
  Vec3 x_, y_;
  std::array<double, most> angles_;
  std::size_t count_ = 0;
};

class SheetSampler {
 public:
  SheetSampler(const SurfacePoints& surface, const EdgeLength& edge, MeshSamples& samples,
               const Job& job)
      : surface_(surface),
        edge_(edge),
        samples_(samples),
        job_(job),
        creases_(edge.step, 2 * samples.creases.size()),
        taken_(1.2 * edge.step, surface.points.size()),
        cloud_(surface.spacing, surface.points.size()),
        strips_(edge.step, samples.creases.size()),
        sheets_(surface, cloud_, 0.5 * edge.step) {
    for (const Vec3& p : samples.position) creases_.insert(p);
    for (const auto& [a, b] : samples.creases)
      creases_.insert((samples.position[a] + samples.position[b]) * 0.5);
    for (const SurfaceFoot& foot : surface.points) cloud_.insert(foot.position);
  }

  void run(const std::vector<SurfaceFoot>& strips) {
    for (const SurfaceFoot& foot : strips) {
      strips_.insert(foot.position);
      add(foot, edge_.step);
    }
    for (std::size_t i = 0; i < surface_.points.size(); ++i) {
      if (i % 65536 == 0) job_.check();
      if (!misled(surface_.points[i])) take(surface_.points[i], false);
    }
    std::size_t begin = samples_.on_creases;
    for (int round = 0; round < most_rounds && begin < samples_.size(); ++round) {
      const std::size_t end = samples_.size();
      for (const SurfaceFoot& foot : find_candidates(begin, end)) take(foot, true);
      begin = end;
    }
  }

 private:
  double length_at(const SurfaceFoot& foot) const {
    if (foot.spacing > sparse * surface_.spacing)
      return edge_.step * foot.spacing / surface_.spacing;
    if (!(edge_.chord_error > 0) || !(foot.curvature > 0)) return edge_.step;
    return std::clamp(std::sqrt(8 * edge_.chord_error / foot.curvature),
                      edge_.shortest * edge_.step, edge_.step);
  }

  void take(const SurfaceFoot& foot, bool between) {
    if (!is_finite(foot.position) || !foot.valid()) return;
    const double length = length_at(foot);
    if (near_crease(foot.position)) return;
    const auto close = [&](std::uint32_t j, double) {
      const std::size_t v = samples_.on_creases + j;
      return same_sheet(foot.position, foot.normal, samples_.position[v], samples_.normal[v]);
    };
    // a sample is worth more than a point between samples: it may stay on a finer mesh
    const double r = sheet_distance * std::min(edge_.step, between ? length : 1.2 * length);
    if (taken_.any_within(foot.position, r, close)) return;
    add(foot, length);
  }

  void add(const SurfaceFoot& foot, double length) {
    taken_.insert(foot.position);
    samples_.position.push_back(foot.position);
    samples_.normal.push_back(foot.normal);
    samples_.length.push_back(length);
  }

  // A point in a strip that took the sheet beside the strip for its own.
  bool misled(const SurfaceFoot& foot) const {
    return strips_.any_within(
        foot.position, strip_reach * edge_.step, [&](std::uint32_t i, double) {
          const Vec3& n = samples_.normal[samples_.on_creases + i];
          return std::abs(dot(foot.position - strips_.points()[i], n)) < strip_depth * edge_.step &&
                 std::abs(dot(foot.normal, n)) < strip_turn;
        });
  }

  bool near_crease(const Vec3& p) const {
    const auto found = [](std::uint32_t, double) { return true; };
    return creases_.any_within(p, crease_distance * edge_.step, found);
  }

  std::vector<SurfaceFoot> find_candidates(std::size_t begin, std::size_t end) const {
    std::vector<std::vector<SurfaceFoot>> found((end - begin) / grain + 1);
    parallel_for(job_, "vertices", end - begin, grain, [&](std::size_t from, std::size_t to) {
      for (std::size_t i = from; i < to; ++i) beside(begin + i, found[from / grain]);
    });
    std::vector<SurfaceFoot> all;
    for (const auto& list : found) all.insert(all.end(), list.begin(), list.end());
    return all;
  }

  // Points in the gaps around a vertex.
  void beside(std::size_t v, std::vector<SurfaceFoot>& out) const {
    const Vec3 &p = samples_.position[v], &n = samples_.normal[v];
    const double length = samples_.length[v];
    Compass compass(n);
    taken_.any_within(p, neighbor_distance * length, [&](std::uint32_t j, double squared) {
      const std::size_t w = samples_.on_creases + j;
      if (squared > 0 && same_sheet(p, n, samples_.position[w], samples_.normal[w]))
        compass.add(samples_.position[w] - p);
      return false;
    });
    add_creases(p, n, std::max(neighbor_distance * length, 1.3 * edge_.step), compass);
    compass.gaps(widest_gap, [&](double angle, double width) {
      const int pieces = std::max(2, static_cast<int>(std::round(width / radians(60))));
      for (int k = 1; k < pieces; ++k) {
        const double a = angle + width * k / pieces;
        const Vec3 query = p + candidate_distance * length * compass.direction(a);
        if (!is_free(query, n, length)) continue;
        const SurfaceFoot foot = sheets_.at(query, n);
        if (foot.valid() && !near_crease(foot.position) && supported(foot)) out.push_back(foot);
      }
    });
  }

  void add_creases(const Vec3& p, const Vec3& n, double r, Compass& compass) const {
    creases_.any_within(p, r, [&](std::uint32_t j, double squared) {
      const Vec3 d = creases_.points()[j] - p;
      if (std::abs(dot(d, n)) < 0.4 * std::sqrt(squared)) compass.add(d);
      return false;
    });
  }

  // Worth asking the sheets: neither taken nor at a crease.
  bool is_free(const Vec3& p, const Vec3& n, double length) const {
    if (near_crease(p)) return false;
    const double r = 0.95 * sheet_distance * length;
    return !taken_.any_within(p, r, [&](std::uint32_t j, double) {
      const std::size_t v = samples_.on_creases + j;
      return same_sheet(p, n, samples_.position[v], samples_.normal[v]);
    });
  }

  // Surface points of the sheet lie all around: it does not end here.
  bool supported(const SurfaceFoot& foot) const {
    Compass compass(foot.normal);
    const double r = support_radius * surface_.spacing;
    cloud_.any_within(foot.position, r, [&](std::uint32_t j, double) {
      const SurfaceFoot& s = surface_.points[j];
      if (s.valid() && same_sheet(foot.position, foot.normal, s.position, s.normal))
        compass.add(s.position - foot.position);
      return false;
    });
    const bool enough = compass.count() >= least_support;
    add_creases(foot.position, foot.normal, std::max(r, 1.3 * edge_.step), compass);
    bool open = false;
    compass.gaps(widest_support_gap, [&](double, double) { open = true; });
    return enough && !open;
  }

  const SurfacePoints& surface_;
  const EdgeLength edge_;
  MeshSamples& samples_;
  const Job& job_;
  PointCells creases_, taken_, cloud_, strips_;
  const Continuation sheets_;
};

// A tip that a crease ends in is a vertex already.
void add_tips(const std::vector<Vec3>& tips, MeshSamples& samples) {
  for (const Vec3& tip : tips) {
    const bool known = std::any_of(
        samples.position.begin(), samples.position.end(),
        [&](const Vec3& p) { return distance(p, tip) < crease_distance * samples.step; });
    if (known) continue;
    samples.position.push_back(tip);
    samples.normal.emplace_back();
    samples.length.push_back(samples.step);
  }
  samples.on_creases = samples.size();
}

}  // namespace

MeshSamples choose_samples(const SurfacePoints& surface, const FeatureCurves& network,
                           const EdgeLength& edge, const Job& job) {
  MeshSamples samples = sample_creases(network, edge.step);
  const std::vector<SurfaceFoot> strips = find_strips(surface, samples, job);
  add_tips(surface.tips, samples);
  samples.strips = strips.size();
  SheetSampler(surface, edge, samples, job).run(strips);
  return samples;
}

}  // namespace spigolo
