// Copyright 2026 The spigolo authors
// SPDX-License-Identifier: Apache-2.0
//
// spigolo/sheets/convexity.cpp
#include "spigolo/sheets/convexity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <unordered_map>
#include <utility>

#include "spigolo/core/parallel.h"
#include "spigolo/index/order.h"
#include "spigolo/sheets/sheet_links.h"

namespace spigolo {
namespace {

constexpr std::size_t linked_across = 16;  // of an edge point, to reach both of its sheets
constexpr std::size_t grain = 1 << 16;     // points whose areas are summed up together
constexpr double near_sheet = 0.35;        // [spacings] height over each other's sheets
constexpr double off_crease = 0.35;        // [spacings] points nearer may be on either sheet
constexpr double closes = 0.12;            // a closed surface has no sum of normals by area
constexpr std::size_t least_piece = 30;    // points

bool has_sides(const SheetVerdict& v) {
  return v.kind == PointKind::edge && !(v.into[0] == Vec3{}) && !(v.into[1] == Vec3{});
}

// An edge's two normals, both outwards or both inwards.
std::array<Vec3, 2> paired_normals(const SheetVerdict& edge) {
  const Vec3 a = cross(edge.direction, edge.into[0]);
  Vec3 b = cross(edge.direction, edge.into[1]);
  if ((dot(a, edge.into[1]) < 0) != (dot(b, edge.into[0]) < 0)) b = -b;
  return {a, b};
}

// What a side of an edge lies on: a set of linked points, and whether its root looks against the
// edge's normal there.
struct SideVote {
  std::uint32_t set = no_point;
  std::uint8_t differ = 0;
};

// The neighbors on each side of the edge, by majority.
std::array<SideVote, 2> ask_sides(const SheetCloud& cloud, std::span<const Vec3> normal,
                                  const SheetVerdict& edge, std::uint32_t i, ParitySets& sets) {
  const std::array<Vec3, 2> pair = paired_normals(edge);
  std::array<std::vector<SideVote>, 2> votes;
  const auto row = cloud.neighborhoods.of(i);
  for (const std::uint32_t j : row.first(std::min(linked_across, row.size()))) {
    const Vec3 off = (cloud.points[j] - edge.crease_point) / cloud.spacing.of_point[i];
    const double on_a = dot(off, edge.into[0]), on_b = dot(off, edge.into[1]);
    const std::size_t side = on_a > on_b ? 0 : 1;
    const double cosine = dot(normal[j], pair[side]);
    if (std::max(on_a, on_b) < off_crease || std::abs(cosine) < one_sheet_cosine) continue;
    const ParitySets::Root root = sets.find(j);
    votes[side].push_back({root.set, static_cast<std::uint8_t>(root.parity ^ (cosine < 0))});
  }
  std::array<SideVote, 2> result;
  for (std::size_t side = 0; side < 2; ++side) {
    std::ptrdiff_t most = 0;
    for (const SideVote& v : votes[side]) {
      const auto same =
          std::count_if(votes[side].begin(), votes[side].end(),
                        [&](const SideVote& o) { return o.set == v.set && o.differ == v.differ; });
      if (same > most) most = same, result[side] = v;
    }
  }
  return result;
}

// Joins what lies on the two sides of each crease, the pairs that most edges agree on first.
void join_over_creases(const SheetCloud& cloud, std::span<const Vec3> normal,
                       const VerdictRows& verdicts, std::span<const std::uint32_t> edges,
                       ParitySets& sets) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::array<int, 2>> votes;
  for (const std::uint32_t i : edges) {
    const auto [a, b] = ask_sides(cloud, normal, verdicts[i], i, sets);
    if (a.set == no_point || b.set == no_point || a.set == b.set) continue;
    ++votes[std::minmax(a.set, b.set)][a.differ ^ b.differ];
  }
  struct Majority {
    int lead;
    std::pair<std::uint32_t, std::uint32_t> sets;
    std::uint8_t differ;
  };
  std::vector<Majority> order;
  for (const auto& [pair, count] : votes)
    order.push_back({std::abs(count[0] - count[1]), pair, count[1] > count[0]});
  std::stable_sort(order.begin(), order.end(),
                   [](const Majority& x, const Majority& y) { return x.lead > y.lead; });
  for (const Majority& m : order) sets.join(m.sets.first, m.sets.second, m.differ);
}

struct Piece {
  Vec3 sum;           // of normals by area
  double volume = 0;  // three times the signed one, about the middle of the cloud
  double area = 0;
  std::size_t points = 0;
};

// 1 if the kind of the piece's root looks outwards, -1 if inwards, 0 if that cannot be told.
int outward(const Piece& piece) {
  if (piece.points < least_piece || norm(piece.sum) > closes * piece.area) return 0;
  return piece.volume > 0 ? 1 : -1;
}

using Pieces = std::unordered_map<std::uint32_t, Piece>;  // by the root of their set

// Sums over stretches of the canonical order, added up in that order.
Pieces measure_pieces(const SheetCloud& cloud, std::span<const Vec3> normal,
                      const ParitySets& flat_sets, const Job& job) {
  const auto stretches = parallel_collect<Pieces>(
      job, cloud.size(), grain, [&](std::size_t begin, std::size_t end, auto& found) {
        Pieces& pieces = found.emplace_back();
        for (std::size_t i = begin; i < end; ++i) {
          if (normal[i] == Vec3{}) continue;
          const ParitySets::Root root = flat_sets.root(static_cast<std::uint32_t>(i));
          const double area = cloud.spacing.of_point[i] * cloud.spacing.of_point[i];
          const Vec3 turned = root.parity ? -normal[i] : normal[i];
          Piece& piece = pieces[root.set];
          piece.sum += turned * area;
          piece.volume += dot(turned, cloud.points[i]) * area;
          piece.area += area;
          ++piece.points;
        }
      });
  Pieces all;
  for (const Pieces& stretch : stretches) {
    for (const auto& [root, part] : stretch) {
      Piece& piece = all[root];
      piece.sum += part.sum;
      piece.volume += part.volume;
      piece.area += part.area;
      piece.points += part.points;
    }
  }
  return all;
}

// Corners take what all edges beside them agree on.
void settle_corners(const SheetCloud& cloud, VerdictRows& verdicts, const Job& job) {
  const auto corners = parallel_select(job, cloud.size(), grain, [&](std::size_t i) {
    return verdicts[i].kind == PointKind::corner;
  });
  for (const std::uint32_t i : corners) {
    int convex = 0, concave = 0;
    for (const std::uint32_t j : cloud.neighborhoods.of(i)) {
      if (verdicts[j].kind != PointKind::edge) continue;
      convex += verdicts[j].convex > 0;
      concave += verdicts[j].convex < 0;
    }
    if (convex == 0 || concave == 0)
      verdicts.edit(i).convex = static_cast<std::int8_t>((convex > 0) - (concave > 0));
  }
}

}  // namespace

void note_convexity(const SheetCloud& cloud, const SheetTolerances& tolerances,
                    VerdictRows& verdicts, const Job& job) {
  const auto edges = parallel_select(job, cloud.size(), grain,
                                     [&](std::size_t i) { return has_sides(verdicts[i]); });
  if (edges.empty()) return;
  const std::vector<Vec3> normal = own_normals(cloud, job);
  const double near = std::max(near_sheet, 3 * tolerances.noise);
  ParitySets sets = link_along_sheets(cloud, normal, near, job);
  join_over_creases(cloud, normal, verdicts, edges, sets);
  sets.flatten();
  const Pieces pieces = measure_pieces(cloud, normal, sets, job);
  for (const std::uint32_t i : edges) {
    SheetVerdict& edge = verdicts.edit(i);
    const auto sides = ask_sides(cloud, normal, edge, i, sets);
    const SideVote& known = sides[0].set != no_point ? sides[0] : sides[1];
    if (known.set == no_point) continue;
    const int side = outward(pieces.at(known.set)) * (known.differ ? -1 : 1);
    const std::array<Vec3, 2> pair = paired_normals(edge);
    const int bends = dot(pair[0], edge.into[1]) < 0 ? 1 : -1;  // away from the first normal
    edge.convex = static_cast<std::int8_t>(side * bends);
  }
  settle_corners(cloud, verdicts, job);
}

}  // namespace spigolo
