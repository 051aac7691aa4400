// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/sides.cpp
#include "spigolo/mesh/sides.h"

#include <algorithm>

#include "spigolo/core/parallel.h"
#include "spigolo/mesh/point_cells.h"

namespace spigolo {
namespace {

constexpr double reach = 2.6;        // [steps] how far vertices tell about a crease
constexpr double strip_reach = 1.5;  // [steps] the middle of a strip is no farther from its creases
constexpr double in_sheet = 0.3;     // sine of the angle between a sheet and the way there
const double same_side = std::cos(radians(18));  // normals closer than this are of one sheet
constexpr double least_wedge = radians(12);      // sheets closer than this are one
constexpr std::size_t grain = 256;

struct Shown {
  double squared_distance;
  std::uint32_t vertex;
  bool operator<(const Shown& o) const {
    return squared_distance != o.squared_distance ? squared_distance < o.squared_distance
                                                  : vertex < o.vertex;
  }
};

class SideFinder {
 public:
  SideFinder(const MeshSamples& samples, const SurfacePoints& surface)
      : samples_(samples),
        surface_(surface),
        cells_(samples.step, samples.size() - samples.on_creases),
        feet_(samples.step, surface.points.size()),
        strips_(samples.step, samples.strips) {
    for (std::size_t v = samples.on_creases; v < samples.size(); ++v)
      cells_.insert(samples.position[v]);
    for (const SurfaceFoot& foot : surface.points) feet_.insert(foot.position);
    for (std::size_t i = 0; i < samples.strips; ++i)
      strips_.insert(samples.position[samples.on_creases + i]);
  }

  SideNormals of_vertex(std::uint32_t v) const {
    SideNormals sides;
    add_strips(samples_.position[v], sides);
    for (const Shown& s : near_feet(samples_.position[v]))
      add(surface_.points[s.vertex].normal, sides);
    return sides;
  }

  SegmentSides of_segment(const VertexPair& segment) const {
    const Vec3 &a = samples_.position[segment[0]], &b = samples_.position[segment[1]];
    const Vec3 t = normalized(b - a), middle = (a + b) * 0.5;
    if (!(squared_norm(t) > 0)) return {};
    const auto shown = near(middle, t);
    if (shown.empty()) return {};
    const auto across = [&](const Shown& s) {
      const Vec3 d = samples_.position[s.vertex] - middle;
      return normalized(d - dot(d, t) * t);
    };
    SegmentSides sides;
    sides.shown_by[0] = shown.front().vertex;
    sides.along[0] = across(shown.front());
    for (const Shown& s : shown) {
      const Vec3 d = across(s);
      if (angle_between(d, sides.along[0]) < least_wedge) continue;
      sides.shown_by[1] = s.vertex;
      sides.along[1] = d;
      sides.known = true;
      break;
    }
    if (sides.known) point_into(t, sides);
    return sides;
  }

 private:
  // Sheet vertices around a place whose sheets pass through it, nearest first; with a tangent t
  // those that lie beside the segment.
  std::vector<Shown> near(const Vec3& p, const Vec3& t) const {
    std::vector<Shown> shown;
    cells_.any_within(p, reach * samples_.step, [&](std::uint32_t i, double squared) {
      const auto v = static_cast<std::uint32_t>(samples_.on_creases + i);
      const Vec3 d = samples_.position[v] - p;
      if (std::abs(dot(d, samples_.normal[v])) > in_sheet * norm(d)) return false;
      if (std::abs(dot(d, t)) > 0.8 * norm(d)) return false;
      if (std::abs(dot(samples_.normal[v], t)) > 0.5) return false;
      shown.push_back({squared, v});
      return false;
    });
    std::sort(shown.begin(), shown.end());
    return shown;
  }

  static void add(const Vec3& n, SideNormals& sides) {
    bool known = false;
    for (std::size_t i = 0; i < sides.count; ++i)
      known |= std::abs(dot(n, sides.normal[i])) > same_side;
    if (!known && sides.count < most_sides) sides.normal[sides.count++] = n;
  }

  // No surface point has the normal of a strip.
  void add_strips(const Vec3& p, SideNormals& sides) const {
    strips_.any_within(p, strip_reach * samples_.step, [&](std::uint32_t i, double squared) {
      const std::size_t v = samples_.on_creases + i;
      const Vec3& n = samples_.normal[v];
      if (std::abs(dot(samples_.position[v] - p, n)) <= in_sheet * std::sqrt(squared))
        add(n, sides);
      return false;
    });
  }

  // Surface points whose sheets pass through a place, nearest first.
  std::vector<Shown> near_feet(const Vec3& p) const {
    std::vector<Shown> shown;
    feet_.any_within(p, reach * samples_.step, [&](std::uint32_t i, double squared) {
      const SurfaceFoot& foot = surface_.points[i];
      if (foot.valid() &&
          std::abs(dot(foot.position - p, foot.normal)) <= in_sheet * std::sqrt(squared))
        shown.push_back({squared, i});
      return false;
    });
    std::sort(shown.begin(), shown.end());
    return shown;
  }

  // Halves the angles between the two sheets, on either side.
  static void point_into(const Vec3& t, SegmentSides& sides) {
    const Vec3 x = sides.along[0], y = cross(t, x);
    double angle = std::atan2(dot(sides.along[1], y), dot(sides.along[1], x));
    if (angle < 0) angle += 2 * pi;
    const auto at = [&](double a) { return std::cos(a) * x + std::sin(a) * y; };
    sides.into = {at(angle / 2), at(angle / 2 + pi)};
  }

  const MeshSamples& samples_;
  const SurfacePoints& surface_;
  PointCells cells_, feet_, strips_;
};

}  // namespace

CreaseSides find_crease_sides(const MeshSamples& samples, const SurfacePoints& surface,
                              const Job& job) {
  const SideFinder finder(samples, surface);
  CreaseSides sides;
  sides.of_vertex.resize(samples.on_creases);
  sides.of_segment.resize(samples.creases.size());
  std::vector<char> at_segment(samples.on_creases, 0);  // not so tips: sheets of all directions
  for (const VertexPair& segment : samples.creases)     // meet there
    for (const std::uint32_t v : segment) at_segment[v] = 1;
  parallel_for(job, "", samples.on_creases, grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v)
      if (at_segment[v]) sides.of_vertex[v] = finder.of_vertex(static_cast<std::uint32_t>(v));
  });
  parallel_for(job, "", samples.creases.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s)
      sides.of_segment[s] = finder.of_segment(samples.creases[s]);
  });
  return sides;
}

}  // namespace spigolo
