// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/mesh/surfaces.cpp - vertices connected, inside told from outside, the surface read
#include "spigolo/mesh/surfaces.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <utility>

#include "spigolo/core/stopwatch.h"
#include "spigolo/mesh/delaunay.h"
#include "spigolo/mesh/label.h"
#include "spigolo/mesh/leftovers.h"
#include "spigolo/mesh/recut.h"
#include "spigolo/mesh/relabel.h"
#include "spigolo/mesh/settle.h"
#include "spigolo/mesh/sides.h"
#include "spigolo/mesh/trim.h"

namespace spigolo {
namespace {

constexpr double jitter_steps = 1e-3;  // what breaks ties between lattice points
constexpr double least_jitter = 2;     // [grid units]
constexpr int split_rounds = 4;
constexpr int most_parts = 6;           // surfaces meshed apart
constexpr std::size_t least_part = 24;  // triangles of a piece of a later one

struct Connected {
  Delaunay delaunay;
  Grid grid;

  /// Where the tetrahedra have a sample, in units of the points.
  Vec3 place(std::uint32_t sample) const {
    return grid.origin + delaunay.point(sample + Delaunay::helpers) / grid.scale;
  }
};

Connected connect(const MeshSamples& samples, const Job& job) {
  Connected connected;
  const Grid grid = connected.grid = make_grid(bounding_box(samples.position));
  const double jitter = std::max(least_jitter, jitter_steps * samples.step * grid.scale);
  std::vector<GridPoint> points(samples.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    points[i] = grid.place(samples.position[i], jitter, i);
  std::vector<std::uint32_t> order(points.size());
  std::iota(order.begin(), order.end(), 0U);
  connected.delaunay.insert(points, order, job);
  return connected;
}

// Segments that are no edges of the tetrahedra.
std::vector<std::size_t> missing_segments(const Delaunay& delaunay, const MeshSamples& samples) {
  std::vector<std::size_t> missing;
  std::vector<std::uint32_t> scratch;
  for (std::size_t s = 0; s < samples.creases.size(); ++s) {
    const std::uint32_t a = samples.creases[s][0] + Delaunay::helpers,
                        b = samples.creases[s][1] + Delaunay::helpers;
    if (!delaunay.has(a) || !delaunay.has(b)) continue;
    delaunay.around(a, b, scratch);
    if (scratch.empty()) missing.push_back(s);
  }
  return missing;
}

// Tetrahedra in which every crease segment is an edge, as far as halving helps.
Connected connect_along_creases(MeshSamples& samples, const Job& job) {
  Connected connected = connect(samples, job);
  for (int round = 0; round < split_rounds; ++round) {
    const auto missing = missing_segments(connected.delaunay, samples);
    if (missing.empty()) break;
    split_creases(samples, missing);
    connected = connect(samples, job);
  }
  return connected;
}

struct Part {
  MeshSamples samples;
  CreaseSides sides;
  std::vector<Triangle> triangles;  // of the samples
};

struct Lost {
  VertexPair segment;
  std::int32_t curve;
};

// The surface through samples: between the sides of their tetrahedra, without what no sample
// supports.
Part find_surface(MeshSamples samples, const SurfacePoints& surface, SharpMesh& result,
                  const Job& job) {
  Stopwatch watch;
  Part part{std::move(samples), {}, {}};
  const Connected connected = connect_along_creases(part.samples, job);
  const Delaunay& delaunay = connected.delaunay;
  result.seconds_tetrahedra += watch.lap();
  part.sides = find_crease_sides(part.samples, surface, job);
  Labelling labels = label_tetrahedra(delaunay, part.samples, part.sides, job);
  recut_labels(delaunay, part.samples, part.sides, labels, job);
  refine_labels(delaunay, part.samples, part.sides, labels, job);
  result.seconds_label += watch.lap();
  part.triangles = boundary(delaunay, labels);
  trim_unsupported(part.triangles, part.samples, Openness(delaunay, part.samples, part.sides), {});
  const auto safe = [&](std::uint32_t v) { return connected.place(v); };
  settle(part.triangles, part.samples.position, safe, job);
  return part;
}

// Triangles from `first` on that run into each other or into those before, and small pieces.
void drop_new_faults(std::size_t first, SharpMesh& result, const Job& job) {
  std::vector<Triangle>& triangles = result.mesh.triangles;
  const auto& points = result.mesh.vertices.points;
  std::vector<char> kept(triangles.size(), 1);
  for (const auto& [a, b] : find_self_intersections(points, triangles, job)) kept[b] = b < first;
  std::vector<Triangle> fresh;
  for (std::size_t t = first; t < triangles.size(); ++t)
    if (kept[t]) fresh.push_back(triangles[t]);
  result.faults_taken += triangles.size() - first - fresh.size();
  drop_scraps(fresh, points.size(), least_part);
  triangles.resize(first);
  triangles.insert(triangles.end(), fresh.begin(), fresh.end());
}

std::size_t count_unused(const Part& part) {
  std::vector<char> used(part.samples.size(), 0);
  for (const Triangle& t : part.triangles)
    for (const std::uint32_t v : t) used[v] = 1;
  return static_cast<std::size_t>(std::count(
      used.begin() + static_cast<std::ptrdiff_t>(part.samples.on_creases), used.end(), 0));
}

// Crease segments by the places of their ends: those of a later part have other vertices.
using Places = std::array<double, 6>;

Places places_of(const Vec3& a, const Vec3& b) {
  const Places one = {a.x, a.y, a.z, b.x, b.y, b.z}, other = {b.x, b.y, b.z, a.x, a.y, a.z};
  return std::min(one, other);
}

// A segment of the first part that is an edge of none is asked for all the same: it is lost.
void add_lost_creases(const std::vector<Lost>& lost, SharpMesh& result) {
  const auto& p = result.mesh.vertices.points;
  std::set<Places> kept;
  for (const auto& [a, b] : result.creases) kept.insert(places_of(p[a], p[b]));
  for (const auto& [segment, curve] : lost) {
    if (kept.count(places_of(p[segment[0]], p[segment[1]])) > 0) continue;
    result.creases.push_back(segment);
    result.curve.push_back(curve);
  }
}

// Crease segments that are no edges of this part may be some of the next.
void append(const Part& part, const MeshSamples* next, SharpMesh& result, std::vector<Lost>& lost,
            const Job& job) {
  std::vector<Vec3>& points = result.mesh.vertices.points;
  const auto base = static_cast<std::uint32_t>(points.size());
  const std::size_t first = result.mesh.triangles.size();
  points.insert(points.end(), part.samples.position.begin(), part.samples.position.end());
  for (Triangle t : part.triangles) {
    for (std::uint32_t& v : t) v += base;
    result.mesh.triangles.push_back(t);
  }
  if (first > 0) drop_new_faults(first, result, job);
  const std::span<const Triangle> added(result.mesh.triangles.data() + first,
                                        result.mesh.triangles.size() - first);
  const EdgeTable table = find_edges(points.size(), added);
  for (std::size_t s = 0; s < part.samples.creases.size(); ++s) {
    const auto [a, b] = part.samples.creases[s];
    const VertexPair segment = {a + base, b + base};
    if (table.find(segment[0], segment[1]) == nullptr) {
      if (first == 0) lost.push_back({segment, part.samples.curve[s]});
      continue;
    }
    result.creases.push_back(segment);
    result.curve.push_back(part.samples.curve[s]);
  }
  result.parts += !added.empty();
  const std::size_t passed_on = next == nullptr ? 0 : next->size() - next->on_creases;
  result.unused_points += count_unused(part) - passed_on;
}

}  // namespace

void find_surfaces(MeshSamples samples, const SurfacePoints& surface, SharpMesh& result,
                   const Job& job) {
  std::vector<Lost> lost;
  for (int i = 0; i < most_parts; ++i) {
    const Part part = find_surface(std::exchange(samples, {}), surface, result, job);
    const auto left = left_out(part.samples, part.triangles);
    const bool last = left.empty() || i + 1 == most_parts;
    if (!last) samples = take_samples(part.samples, part.sides, left);
    append(part, last ? nullptr : &samples, result, lost, job);
    if (last) break;
  }
  add_lost_creases(lost, result);
}

}  // namespace spigolo
