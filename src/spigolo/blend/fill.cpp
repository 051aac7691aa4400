// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/blend/fill.cpp
#include "spigolo/blend/fill.h"

#include <algorithm>
#include <cmath>

#include "spigolo/blend/eliminate.h"
#include "spigolo/blend/scatter.h"
#include "spigolo/core/error.h"
#include "spigolo/core/parallel.h"

namespace spigolo {
namespace {

constexpr double most_candidates = 3e8;  // more are no blend but two different units
constexpr double oversampling = 6;       // candidates for each point that stays
constexpr double least_distance = 0.5;   // [spacings] of a collar point from the kept cloud
constexpr std::size_t grain = 256;

double between(double a, double b, double share) { return a + (b - a) * share; }

// The kept part of the face as a grid: a row a strand, columns from the start to alpha.
class FaceGrid {
 public:
  FaceGrid(const TracedStart& t, double spacing) : t_(t) {
    double longest = 0;
    for (const Strand& s : t.loop.strands) {
      double length = 0;
      Vec3 last = t.isolines.at(s.line.cross, s.line.begin).point;
      for (int i = 1; i <= 16; ++i) {
        const double along = between(s.line.begin, s.alpha_at, i / 16.0);
        const Vec3 p = t.isolines.at(s.line.cross, along).point;
        length += distance(p, last);
        last = p;
      }
      longest = std::max(longest, length);
    }
    columns_ = static_cast<std::size_t>(std::max(1.0, std::ceil(longest / spacing)));
  }

  CellGrid cells() const {
    const std::size_t n = t_.loop.strands.size();
    return {t_.loop.closed ? n : n - 1, columns_,
            [this](double row, double column) { return at(row, column).point; }};
  }
  IsoPoint at(double row, double column) const {
    const auto [cross, along] = parameters(row, column);
    return t_.isolines.at(cross, along);
  }
  bool on_face(double row, double column) const {
    const auto [cross, along] = parameters(row, column);
    return t_.isolines.on_face(cross, along);
  }

 private:
  std::pair<double, double> parameters(double row, double column) const {
    const std::vector<Strand>& strands = t_.loop.strands;
    const std::size_t n = strands.size();
    const auto i = std::min(static_cast<std::size_t>(row), n - 1);
    const double share = row - static_cast<double>(i);
    const Strand &a = strands[i], &b = strands[(i + 1) % n];
    double step = share > 0 ? b.line.cross - a.line.cross : 0;
    if (step < 0) step += t_.isolines.range().length();
    const double begin = between(a.line.begin, b.line.begin, share),
                 end = between(a.alpha_at, b.alpha_at, share);
    return {a.line.cross + step * share,
            between(begin, end, column / static_cast<double>(columns_))};
  }

  const TracedStart& t_;
  std::size_t columns_ = 1;
};

// The collar as a grid: a row a strand, columns from alpha to beta.
class CollarGrid {
 public:
  CollarGrid(const TracedStart& t, const Collar& collar, double spacing) : t_(t), collar_(collar) {
    double longest = 0;
    for (const Strand& s : t.loop.strands)
      longest = std::max(longest, distance(s.alpha, s.x) + distance(s.x, s.beta));
    columns_ = static_cast<std::size_t>(std::max(4.0, std::ceil(2 * longest / spacing)));
  }
  CellGrid cells() const {
    const std::size_t n = t_.loop.strands.size();
    return {t_.loop.closed ? n : n - 1, columns_, [this](double row, double column) {
              return point_at(collar_.surface, u(row), v(column));
            }};
  }
  double u(double row) const {
    const std::size_t n = collar_.station.size();
    const auto i = std::min(static_cast<std::size_t>(row), n - 1);
    const double a = collar_.station[i], b = i + 1 < n ? collar_.station[i + 1] : 1.0;
    return between(a, b, row - static_cast<double>(i));
  }
  double v(double column) const { return column / static_cast<double>(columns_); }

 private:
  const TracedStart& t_;
  const Collar& collar_;
  std::size_t columns_ = 1;
};

void require_moderate(const CellGrid& cells) {
  const double candidates = static_cast<double>(cells.rows) * static_cast<double>(cells.columns);
  if (candidates > most_candidates)
    throw NoResultError(
        "the part of the face that stays is far too large to be sampled as densely "
        "as the cloud; are cloud and face in the same unit?");
}

struct Candidates {
  std::vector<FilledPoint> points;
  double area = 0;
};

void add_face(const TracedStart& t, std::uint32_t border, double spacing, Random& random,
              Candidates& out, const Job& job) {
  const FaceGrid grid(t, spacing);
  double area = 0;
  const double density = oversampling / (spacing * spacing);
  require_moderate(grid.cells());
  const std::vector<GridPlace> places = scatter(grid.cells(), density, random, area, job);
  std::vector<FilledPoint> points(places.size());
  std::vector<char> on_face(places.size());
  parallel_for(job, "samples of the face", places.size(), grain,
               [&](std::size_t begin, std::size_t end) {
                 for (std::size_t i = begin; i < end; ++i) {
                   const IsoPoint p = grid.at(places[i].row, places[i].column);
                   points[i] = {p.point, p.normal * t.loop.side, BlendSource::nurbs, border};
                   on_face[i] = grid.on_face(places[i].row, places[i].column);
                 }
               });
  std::size_t inside = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (on_face[i]) out.points.push_back(points[i]), ++inside;
  if (!points.empty())
    out.area += area * static_cast<double>(inside) / static_cast<double>(points.size());
}

void add_collar(const TracedStart& t, const Collar& collar, std::uint32_t border, double spacing,
                Random& random, Candidates& out, const Job& job) {
  const CollarGrid grid(t, collar, spacing);
  double area = 0;
  const double density = oversampling / (spacing * spacing);
  for (const GridPlace& place : scatter(grid.cells(), density, random, area, job)) {
    const double u = grid.u(place.row), v = grid.v(place.column);
    out.points.push_back(
        {point_at(collar.surface, u, v), collar_normal(collar, u, v), BlendSource::collar, border});
  }
  out.area += area;
}

// The kept samples of the cloud, for candidates near them.
class KeptCloud {
 public:
  KeptCloud(const CloudSide& cloud, const std::vector<char>& removed)
      : cloud_(cloud), removed_(removed) {}

  template <class Visit>
  void for_each_within(const Vec3& p, double radius, Visit&& visit) const {
    thread_local std::vector<Neighbor> found;
    cloud_.tree().within(p, radius, found);
    for (const Neighbor& n : found)
      if (!removed_[n.index]) visit(n.squared_distance);
  }

 private:
  const CloudSide& cloud_;
  const std::vector<char>& removed_;
};

void drop_crowding(const KeptCloud& kept, double spacing, std::vector<FilledPoint>& points,
                   const Job& job) {
  std::vector<char> drop(points.size(), 0);
  parallel_for(job, "", points.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      kept.for_each_within(points[i].point, least_distance * spacing, [&](double) { drop[i] = 1; });
  });
  std::size_t stay = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!drop[i]) points[stay++] = points[i];
  points.resize(stay);
}

}  // namespace

std::vector<FilledPoint> fill_blend(const CloudSide& cloud, const std::vector<char>& removed,
                                    const std::vector<TracedStart>& traced,
                                    const std::vector<Collar>& collars, std::uint64_t seed,
                                    const Job& job) {
  const double d = cloud.spacing();
  Candidates candidates;
  for (std::size_t i = 0; i < traced.size(); ++i) {
    Random random(seed + i);
    const auto border = static_cast<std::uint32_t>(i);
    add_face(traced[i], border, d, random, candidates, job);
    add_collar(traced[i], collars[i], border, d, random, candidates, job);
  }
  const KeptCloud kept(cloud, removed);
  drop_crowding(kept, d, candidates.points, job);
  std::vector<Vec3> places(candidates.points.size());
  for (std::size_t i = 0; i < places.size(); ++i) places[i] = candidates.points[i].point;
  const FixedPoints fixed = [&](const Vec3& p, double radius, const auto& visit) {
    kept.for_each_within(p, radius, visit);
  };
  const auto wanted = static_cast<std::size_t>(std::round(candidates.area / (d * d)));
  const std::vector<char> stays = eliminate(places, wanted, d, fixed, job);
  std::vector<FilledPoint> out;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (stays[i]) out.push_back(candidates.points[i]);
  return out;
}

}  // namespace spigolo
